/// What regions cost to be traced, by settings and by what they show: measured by the caller (the core has no clock), and
/// followed by an exponential mean. Plain data; equal measurements give equal tables.
#pragma once

#include "render_core/raytrace/picture/region_view.hpp"

namespace tedavis::raytrace {

struct TraceCosts {
    static constexpr std::uint32_t kMaxLevels = PictureVariants::kMax;
    static constexpr float kMemory = 0.75f;  ///< of the old mean that stays with a measurement

    float ms[kMaxLevels][kRegionKinds] = {};  ///< of a region
    bool is_measured[kMaxLevels][kRegionKinds] = {};

    [[nodiscard]] float of(std::uint32_t level, RegionKind kind) const { return ms[level][static_cast<std::size_t>(kind)]; }
    /// Before anything has been measured.
    void expect(std::uint32_t level, RegionKind kind, float region_ms);
    /// A region, or the mean of several. The first measurement takes the place of what was expected. What is not above 0 and
    /// finite is left out.
    void measure(std::uint32_t level, RegionKind kind, float region_ms);
    /// A whole picture whose regions had these levels: where only its time is known. All costs that took part are scaled alike.
    void measure_picture(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels, float picture_ms);
    [[nodiscard]] double sum(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels) const;
};

}  // namespace tedavis::raytrace
