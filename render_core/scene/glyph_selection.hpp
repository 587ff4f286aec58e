/// Which glyphs of a field a view shows: single ones, and groups whose members would be too small to be told apart.
///
/// A site whose glyph is least_px or more across is drawn itself. Groups of smaller ones that cover no more of the screen than a
/// square of cell_px are one glyph at their mean place, as large as such a square; a small one that has its cell alone is drawn
/// itself at least_px. As areas count, what is seen at a grazing angle becomes fewer glyphs, not a heap of them.
/// Where that would be more glyphs than may be drawn, groups are parted in the order of their extent on the screen, largest
/// first, until there is no room for more: what is far and dense stays together, and the rest of the counts say how much.
///
/// Every site that was given is counted once: drawn itself, part of an aggregate (also what the field merged), or hidden: outside
/// the view (misplaced ones as well), or in a context that is not shown. What terrain covers is not known here, and counts as
/// drawn.
///
/// Where regions of the screen keep less of their detail, larger groups are one glyph; so are, however large they are on the
/// screen, groups of up to kCrowdedAcross of their glyphs across.
///
/// The selection depends on nothing but its arguments. Frames  eye and glyphs in ECEF. Memory  from an arena, at start(). Thread
/// one. Bounded: time grows with the number of glyphs that may be drawn, and with the groups that the view's border cuts.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/scene/detail_regions.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/scene/glyph_field.hpp"

namespace tedavis::scene {

/// A pinhole: unit vectors in ECEF, tangents of half the angles across and down.
struct GlyphView {
    earth::Ecef eye{0};
    glm::dvec3 forward{0}, right{0}, down{0};
    double half_width_tangent = 1, half_height_tangent = 1;
    double focal_px = 1;  ///< pixels a unit tangent
    double near_m = 1, far_m = 400000;
};

inline constexpr double kCoarsestGlyphs = 8;
inline constexpr double kCrowdedAcross = 6;  ///< where nothing is kept

/// What foci make of glyphs. Groups that a focus reaches into are shown as without foci; beyond, `coarser` times as large ones
/// stand for their members, by the greatest degree of any place of the group. Those of a data focus for the glyphs' own values
/// are judged by their value where they stand for themselves or are no part of its region.
struct GlyphFocus {
    static constexpr std::size_t kSteps = 16;

    const FocusRegions* regions = nullptr;
    std::array<FocusValueRange, kMaxFoci> ranges{};
    std::array<bool, kMaxFoci> by_value{};     ///< which foci mean the glyphs' own values
    std::array<double, kSteps + 1> coarser{};  ///< by degrees from 0 to 1: times as large least_px and cell_px
    std::array<double, kSteps + 1> across{};   ///< likewise: groups so many of their glyphs wide are one; 1: none is for that
    double least_degree = 0;                   ///< of the intermediate context
    bool hides_context = false;
};

struct GlyphSettings {
    double least_px = 6;   ///< at full detail
    double cell_px = 24;   ///< at full detail, at least least_px
    double most_px = 160;  ///< nothing is drawn larger, however near
    double detail = 1;     ///< 0..1: at 0 least_px and cell_px are `coarsest` times as large
    double coarsest = kCoarsestGlyphs;
    std::uint32_t most_drawn = 0xFFFFFFFFu;
    const GlyphFocus* focus = nullptr;       ///< null: everything is in the focus
    const DetailRegions* regions = nullptr;  ///< of the screen, which lower `detail` beside foci; null: none does
};
struct SelectedGlyph {
    GlyphSummary summary;  ///< its place relative to the eye, in ECEF axes
    float size_m = 0;      ///< across, as it is to be drawn
    float size_px = 0;     ///< the same on the screen
    bool is_aggregate = false;
    std::uint8_t degree = kInFocus;  ///< of focus: 0 in the context, in between 1..254

    static constexpr std::uint8_t kInFocus = 255;
};
static_assert(sizeof(SelectedGlyph) == 68);
/// 0..1
[[nodiscard]] constexpr double degree_of(const SelectedGlyph& glyph) {
    return static_cast<double>(glyph.degree) / SelectedGlyph::kInFocus;
}

/// drawn + aggregated + hidden are all sites that were given.
struct GlyphCounts {
    std::uint32_t drawn = 0, aggregated = 0, hidden = 0;
    std::uint32_t glyphs = 0;     ///< selected: the drawn ones and the aggregates
    std::uint32_t over_most = 0;  ///< of the aggregated and hidden, members of groups that were not parted for want of room
};

class GlyphSelection {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t glyphs);
    /// Once. False when the arena cannot hold so many.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t most_glyphs);

    /// A field that is not ready is hidden.
    const GlyphCounts& select(const GlyphField& field, const GlyphView& view, const GlyphSettings& settings);
    [[nodiscard]] base::Span<const SelectedGlyph> glyphs() const { return {glyphs_.data(), counts_.glyphs}; }
    [[nodiscard]] const GlyphCounts& counts() const { return counts_; }

private:
    static constexpr int kPlanes = 6;
    static constexpr unsigned kAllPlanes = (1u << kPlanes) - 1;
    /// A part of the field that may be in view; planes that it may cut.
    struct Part {
        GlyphRef ref;
        unsigned planes = 0;
        float extent_px = 0;
    };
    struct Plane {
        glm::dvec3 inwards{0};
        double offset_m = 0;
    };
    static constexpr std::size_t kMaxParts = 66;  // of a field's tree, down to its deepest leaf

    void set_view(const GlyphField& field, const GlyphView& view, const GlyphSettings& settings);
    [[nodiscard]] bool select_all();
    void select_largest();
    [[nodiscard]] bool enters(Part& part);
    [[nodiscard]] bool is_whole(const Part& part);
    void emit(const Part& part);
    [[nodiscard]] bool is_in_view(const GlyphSummary& summary, double room_m, unsigned& planes) const;
    [[nodiscard]] double extent_m(const GlyphSummary& summary) const;
    [[nodiscard]] double px_of(double length_m, double distance_m) const;
    [[nodiscard]] double distance_m(const GlyphSummary& summary) const;
    [[nodiscard]] double greatest_degree(const GlyphSummary& summary) const;
    [[nodiscard]] std::size_t step_of(const GlyphSummary& summary) const;
    [[nodiscard]] double coarser(const GlyphSummary& summary) const;
    [[nodiscard]] double given_way(const GlyphSummary& summary) const;
    [[nodiscard]] bool stands_for_all(const GlyphSummary& summary) const;
    [[nodiscard]] std::uint8_t degree_of(const GlyphSummary& summary) const;

    base::Span<SelectedGlyph> glyphs_;
    base::Span<Part> waiting_;
    const GlyphField* field_ = nullptr;
    GlyphSettings settings_;
    Plane planes_[kPlanes];
    /// A focus region's plane along the field's axes: east and north of a place.
    struct FocusPlane {
        glm::dvec3 east{0}, north{0};
        glm::dvec2 offset_m{0};
    };
    FocusPlane focus_planes_[kMaxFoci];
    glm::dvec3 eye_{0};                           ///< along the field's axes
    glm::dvec3 forward_{0}, right_{0}, down_{0};  ///< in the field's axes; over the tangents of half the view
    double focal_px_ = 1;
    GlyphCounts counts_;
};

}  // namespace tedavis::scene
