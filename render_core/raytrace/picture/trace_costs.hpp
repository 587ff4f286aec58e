/// Times to trace regions, by settings and by what they show: measured by the caller (the core has no clock) and averaged
/// exponentially. Plain data; equal measurements give equal tables.
#pragma once

#include "render_core/raytrace/picture/region_view.hpp"

namespace tedavis::raytrace {

struct TraceCosts {
    static constexpr std::uint32_t kMaxLevels = PictureVariants::kMax;
    static constexpr float kMemory = 0.75f;  ///< weight of the old mean after a measurement

    float ms[kMaxLevels][kRegionKinds] = {};  ///< per region
    bool is_measured[kMaxLevels][kRegionKinds] = {};

    [[nodiscard]] float of(std::uint32_t level, RegionKind kind) const { return ms[level][static_cast<std::size_t>(kind)]; }
    /// Sets an expected cost before anything has been measured.
    void expect(std::uint32_t level, RegionKind kind, float region_ms);
    /// Adds the time of a region, or the mean of several. The first measurement replaces the expected cost. Values that are not
    /// finite and above 0 are ignored.
    void measure(std::uint32_t level, RegionKind kind, float region_ms);
    /// Adds the time of a whole picture whose regions had these levels, where only that is known. All costs involved are scaled
    /// by the same factor.
    void measure_picture(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels, float picture_ms);
    [[nodiscard]] double sum(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels) const;
};

}  // namespace tedavis::raytrace
