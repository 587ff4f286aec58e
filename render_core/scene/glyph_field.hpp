/// Places that have glyphs, in a tree of groups: who draws may show a group by what is common to its members (glyph_summary.hpp).
///
/// Groups are the cells of a cube that is halved again and again, along one axis after the other (a binary radix tree over Morton
/// codes: T. Karras, Maximizing parallelism in the construction of BVHs, octrees, and k-d trees, HPG 2012), so that they do not
/// depend on the eye. Every summary is made of its members' sums in double.
///
/// Where more sites come than there is room for, neighbours are merged: all that share a cell, cells alike for the whole field.
/// Each remaining leaf then is a group itself. Merged leaves keep means in float, rounded again each time that they merge.
///
/// Frames  places come in ECEF and are kept in metres along the field's axes from its anchor. Memory  from an arena, at start().
/// Thread  one. Bounded: steps of so many sites; only an add() that finds the field full sorts what is there.
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
    float value = 0;       ///< towards east, m/s; the number; the class. Not finite: missing
    float north_mps = 0;   ///< of wind
    float size_m = 0;      ///< across the glyph, not negative
    float over_ground_m = std::numeric_limits<float>::quiet_NaN();  ///< NaN: not known, or not asked for
    Uncertainty uncertainty;
    ValueState state = ValueState::valid;
};

/// Cells are cubes along the axes.
struct GlyphFrame {
    earth::Ecef anchor{0};
    glm::dmat3 axes{1};  ///< columns, orthonormal: east, north, up at the anchor, or what else the cells are to follow
    double reach_m = 1;  ///< sites may be so far from the anchor along an axis; those much farther out are badly grouped
};
/// At the anchor, with east, north and up there.
[[nodiscard]] GlyphFrame level_frame(const earth::Geodetic& anchor, double reach_m) noexcept;

/// A site (or what was merged to one) or a group.
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

/// Groups have two parts each.
struct GlyphGroup {
    GlyphSummary summary;
    GlyphRef parts[2];
};

enum class GlyphProgress : std::uint8_t { more, done };

class GlyphField {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t sites);
    /// The most sites that so many bytes hold.
    [[nodiscard]] static std::uint32_t sites_within(std::uint64_t bytes);
    /// For kMinGlyphSites..kMaxGlyphSites sites; again with other memory, which forgets what there was. False when the arena
    /// cannot hold it.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t most_sites);

    /// Forgets what there was.
    void begin(const GlyphFrame& frame, GlyphValues values);
    /// False where the place is not finite: such a site is counted as misplaced.
    bool add(const GlyphSite& site);
    /// Puts the groups together, looking at so many sites at most; the result does not depend on the steps. Nothing may be added
    /// after the first step.
    GlyphProgress step(std::uint32_t most_sites);
    [[nodiscard]] bool is_ready() const { return phase_ == Phase::ready; }

    [[nodiscard]] const GlyphFrame& frame() const { return frame_; }
    [[nodiscard]] GlyphValues values() const { return values_; }
    /// All that was given, misplaced ones as well.
    [[nodiscard]] std::uint32_t given() const { return given_; }
    [[nodiscard]] std::uint32_t misplaced() const { return misplaced_; }
    [[nodiscard]] std::uint32_t leaves() const { return count_; }
    [[nodiscard]] std::uint32_t most_sites() const { return static_cast<std::uint32_t>(leaves_.size()); }

    /// Once it is ready and has leaves. Places along the frame's axes.
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
    /// What waits for its second part.
    struct Waiting {
        GlyphSums sums;  ///< of the first part
        GlyphRef first;
        std::uint32_t group = 0;  ///< which it will be
        int bit = 0;              ///< the highest in which its parts differ
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
    int shift_ = kIndexBits;  ///< of codes, to the cells whose sites are merged; they only grow
    std::uint32_t cursor_ = 0, count_ = 0, given_ = 0, misplaced_ = 0;
};

}  // namespace tedavis::scene
