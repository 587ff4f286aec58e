/// Selects the glyphs of a field for a view: single ones, and aggregates of groups whose members would be too small to
/// distinguish.
///
/// A site whose glyph is at least least_px across is drawn itself. A group of smaller ones that covers no more of the screen
/// than a square of cell_px is one glyph at their mean position, as large as that square; a small glyph alone in its cell is
/// drawn at least_px. Since screen areas count, sites seen at a grazing angle become fewer glyphs instead of overlapping ones.
/// Where that would be more glyphs than may be drawn, groups are split in the order of their extent on the screen, largest
/// first, until the limit is reached: distant and dense groups stay aggregated, and `over_most` counts their members.
///
/// Every added site is counted once: drawn itself, aggregated (also where the field merged it), or hidden: outside the view,
/// misplaced, or in a context that is not shown. Occlusion by terrain is not considered: such sites count as drawn.
///
/// Where regions of the screen keep less detail, larger groups become one glyph; so do groups of up to kCrowdedAcross glyphs
/// across, however large they are on the screen.
///
/// The selection depends only on its arguments. Frames  eye point and glyphs in ECEF. Memory  from an arena, at start(). Thread
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

/// A pinhole camera: unit vectors in ECEF, tangents of half the horizontal and vertical angles of view.
struct GlyphView {
    earth::Ecef eye{0};
    glm::dvec3 forward{0}, right{0}, down{0};
    double half_width_tangent = 1, half_height_tangent = 1;
    double focal_px = 1;  ///< pixels per unit tangent
    double near_m = 1, far_m = 400000;
};

inline constexpr double kCoarsestGlyphs = 8;
inline constexpr double kCrowdedAcross = 6;  ///< at detail 0

/// The effect of foci on glyphs. Groups that a focus reaches into are shown as without foci; elsewhere groups up to `coarser`
/// times as large become one glyph, by the greatest degree of any point of the group. For a data focus on the glyphs' own
/// values, single glyphs and glyphs outside its region have the degree of their value.
struct GlyphFocus {
    static constexpr std::size_t kSteps = 16;

    const FocusRegions* regions = nullptr;
    std::array<FocusValueRange, kMaxFoci> ranges{};
    std::array<bool, kMaxFoci> by_value{};     ///< which foci select by the glyphs' own values
    std::array<double, kSteps + 1> coarser{};  ///< by degree 0..1: factor of least_px and cell_px
    std::array<double, kSteps + 1> across{};   ///< by degree 0..1: groups up to this many glyphs wide become one; 1: no effect
    double least_degree = 0;                   ///< least degree of the intermediate context
    bool hides_context = false;
};

struct GlyphSettings {
    double least_px = 6;   ///< at full detail
    double cell_px = 24;   ///< at full detail, at least least_px
    double most_px = 160;  ///< upper limit of a glyph's size
    double detail = 1;     ///< 0..1; at 0 least_px and cell_px are multiplied by `coarsest`
    double coarsest = kCoarsestGlyphs;
    std::uint32_t most_drawn = 0xFFFFFFFFu;
    const GlyphFocus* focus = nullptr;       ///< null: everything is in the focus
    const DetailRegions* regions = nullptr;  ///< regions of the screen that lower `detail` outside foci; null: none
};
struct SelectedGlyph {
    GlyphSummary summary;  ///< its position is relative to the eye point, in ECEF axes
    float size_m = 0;      ///< drawn size across
    float size_px = 0;     ///< the same on the screen
    bool is_aggregate = false;
    std::uint8_t degree = kInFocus;  ///< focus degree: 0 in the context, 1..254 between, kInFocus in the focus

    static constexpr std::uint8_t kInFocus = 255;
};
static_assert(sizeof(SelectedGlyph) == 68);
/// 0..1
[[nodiscard]] constexpr double degree_of(const SelectedGlyph& glyph) {
    return static_cast<double>(glyph.degree) / SelectedGlyph::kInFocus;
}

/// drawn + aggregated + hidden is the number of added sites.
struct GlyphCounts {
    std::uint32_t drawn = 0, aggregated = 0, hidden = 0;
    std::uint32_t glyphs = 0;     ///< selected glyphs: single ones and aggregates
    std::uint32_t over_most = 0;  ///< aggregated and hidden sites in groups that were not split because the limit was reached
};

class GlyphSelection {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t glyphs);
    /// To be called once. Returns false when the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t most_glyphs);

    /// Selects the glyphs; all sites of a field that is not ready are hidden.
    const GlyphCounts& select(const GlyphField& field, const GlyphView& view, const GlyphSettings& settings);
    [[nodiscard]] base::Span<const SelectedGlyph> glyphs() const { return {glyphs_.data(), counts_.glyphs}; }
    [[nodiscard]] const GlyphCounts& counts() const { return counts_; }

private:
    static constexpr int kPlanes = 6;
    static constexpr unsigned kAllPlanes = (1u << kPlanes) - 1;
    /// A part of the field that may be in view, and the frustum planes that it may intersect.
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
    [[nodiscard]] double decluttered_share(const GlyphSummary& summary) const;
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
