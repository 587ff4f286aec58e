/// Sites that have glyphs, in a tree of groups. A group may be shown by one glyph with the summary of its members
/// (glyph_summary.hpp).
///
/// Groups are the cells of a cube that is bisected recursively along its axes in turn (a binary radix tree over Morton codes:
/// T. Karras, Maximizing parallelism in the construction of BVHs, octrees, and k-d trees, HPG 2012), so they do not depend on
/// the eye point. Every summary is computed from its members' sums in double.
///
/// Where more sites are added than there is room for, neighbours are merged: all sites that share a cell, with cells of equal
/// size in the whole field. A merged leaf is then a group itself; it stores means in float, which are rounded at each merge.
///
/// Frames  sites are added in ECEF and stored in metres along the field's axes from its anchor. Memory  from an arena, at
/// start().
/// Thread  one. Bounded: each step visits a limited number of sites; only an add() to a full field sorts all of them.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/glyph_sums.hpp"

namespace tedavis::scene {

inline constexpr std::uint32_t kMinGlyphSites = 16;
inline constexpr std::uint32_t kMaxGlyphSites = 1u << 19;

struct GlyphSite {
    earth::Ecef place{0};  ///< m
    float value = 0;       ///< wind: towards east, m/s; number: the value; category: the class. Not finite: missing
    float north_mps = 0;   ///< wind: towards north
    float size_m = 0;      ///< across the glyph, not negative
    float over_ground_m = std::numeric_limits<float>::quiet_NaN();  ///< height above ground; NaN: unknown or not requested
    Uncertainty uncertainty;
    ValueState state = ValueState::valid;
};

/// The field's frame; its cells are cubes along the axes.
struct GlyphFrame {
    earth::Ecef anchor{0};
    glm::dmat3 axes{1};  ///< orthonormal columns: east, north, up at the anchor, or other axes for the cells
    double reach_m = 1;  ///< largest distance of sites from the anchor along an axis; sites far beyond are grouped badly
};
/// Returns the frame at the anchor with its east, north and up axes.
[[nodiscard]] GlyphFrame level_frame(const earth::Geodetic& anchor, double reach_m) noexcept;

/// Refers to a site (or a merged leaf) or to a group.
class GlyphRef {
public:
    constexpr GlyphRef() = default;
    [[nodiscard]] static constexpr GlyphRef leaf(std::uint32_t n) { return GlyphRef(n | kLeafBit); }
    [[nodiscard]] static constexpr GlyphRef group(std::uint32_t n) { return GlyphRef(n); }
    [[nodiscard]] constexpr bool is_leaf() const { return (code_ & kLeafBit) != 0; }
    [[nodiscard]] constexpr std::uint32_t index() const { return code_ & ~kLeafBit; }

private:
    static constexpr std::uint32_t kLeafBit = 0x80000000u;
    explicit constexpr GlyphRef(std::uint32_t code) : code_(code) {}
    std::uint32_t code_ = 0;
};

/// A group; it has two parts.
struct GlyphGroup {
    GlyphSummary summary;
    GlyphRef parts[2];
};

enum class GlyphProgress : std::uint8_t { more, done };

class GlyphField {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t sites);
    /// Returns the number of sites that fit in `bytes`.
    [[nodiscard]] static std::uint32_t sites_within(std::uint64_t bytes);
    /// Allocates room for kMinGlyphSites..kMaxGlyphSites sites. May be called again with other memory, which clears the field.
    /// Returns false when the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t most_sites);

    /// Clears the field and begins a new one.
    void begin(const GlyphFrame& frame, GlyphValues values);
    /// Adds a site. Returns false, and counts it as misplaced, where its position is not finite.
    bool add(const GlyphSite& site);
    /// Builds groups, visiting at most `most_sites` sites; the result does not depend on the size of the steps. No site may be
    /// added after the first step.
    GlyphProgress step(std::uint32_t most_sites);
    [[nodiscard]] bool is_ready() const { return phase_ == Phase::ready; }

    [[nodiscard]] const GlyphFrame& frame() const { return frame_; }
    [[nodiscard]] GlyphValues values() const { return values_; }
    /// Number of added sites, misplaced ones included.
    [[nodiscard]] std::uint32_t given() const { return given_; }
    [[nodiscard]] std::uint32_t misplaced() const { return misplaced_; }
    [[nodiscard]] std::uint32_t leaves() const { return count_; }
    [[nodiscard]] std::uint32_t most_sites() const { return static_cast<std::uint32_t>(leaves_.size()); }

    /// Valid once the field is ready and has leaves. Positions are along the frame's axes.
    [[nodiscard]] GlyphRef root() const { return root_; }
    [[nodiscard]] const GlyphSummary& summary(GlyphRef ref) const {
        return ref.is_leaf() ? leaves_[ref.index()] : groups_[ref.index()].summary;
    }
    [[nodiscard]] const GlyphGroup& group(GlyphRef ref) const { return groups_[ref.index()]; }

private:
    static constexpr int kKeyBits = 45, kIndexBits = 19, kDigitBits = 9, kPasses = kKeyBits / kDigitBits;
    static constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
    static constexpr std::uint32_t kNoLimit = 0xFFFFFFFFu;
    static_assert(kMaxGlyphSites == 1u << kIndexBits && kPasses % 2 == 1);

    enum class Phase : std::uint8_t { collecting, coding, counting, scattering, gathering, placing, linking, ready };
    /// A group that waits for its second part.
    struct Waiting {
        GlyphSums sums;  ///< sums of the first part
        GlyphRef first;
        std::uint32_t group = 0;  ///< index that the group will have
        int bit = 0;              ///< highest bit in which its parts differ
    };

    [[nodiscard]] std::uint64_t code(const glm::vec3& place) const;
    void advance(Phase last, std::uint32_t most_sites);
    void visit(std::uint32_t n);
    void end_phase();
    void sum_up_digits();
    void merge();
    void unite_cells();
    void keep_within_cell(GlyphSums& sums, const glm::vec3& place) const;
    [[nodiscard]] int merging_shift() const;
    void link(std::uint32_t n);
    [[nodiscard]] base::Span<std::uint64_t> from_keys() { return pass_ % 2 == 0 ? keys_ : other_keys_; }
    [[nodiscard]] base::Span<std::uint64_t> to_keys() { return pass_ % 2 == 0 ? other_keys_ : keys_; }

    base::Span<GlyphSummary> leaves_;
    base::Span<GlyphGroup> groups_;
    base::Span<std::uint64_t> keys_, other_keys_;  ///< code, then index; sorted ones end up in other_keys_
    std::uint32_t digits_[kDigits] = {};
    Waiting waiting_[kKeyBits + kIndexBits + 1];
    std::uint32_t waiting_count_ = 0;
    GlyphFrame frame_;
    GlyphValues values_ = GlyphValues::number;
    Phase phase_ = Phase::collecting;
    GlyphRef root_;
    int pass_ = 0;
    int shift_ = kIndexBits;  ///< shift from codes to the cells whose sites are merged; cells only grow
    std::uint32_t cursor_ = 0, count_ = 0, given_ = 0, misplaced_ = 0;
};

}  // namespace tedavis::scene
