#include "render_core/raytrace/picture/trace_costs.hpp"

#include <cmath>

namespace tedavis::raytrace {

void TraceCosts::expect(std::uint32_t level, RegionKind kind, float region_ms) {
    TEDAVIS_CHECK(level < kMaxLevels);
    ms[level][static_cast<std::size_t>(kind)] = region_ms;
    is_measured[level][static_cast<std::size_t>(kind)] = false;
}

void TraceCosts::measure(std::uint32_t level, RegionKind kind, float region_ms) {
    TEDAVIS_CHECK(level < kMaxLevels);
    if (!(region_ms > 0) || !std::isfinite(region_ms)) return;
    float& mean = ms[level][static_cast<std::size_t>(kind)];
    bool& is_known = is_measured[level][static_cast<std::size_t>(kind)];
    mean = is_known ? kMemory * mean + (1 - kMemory) * region_ms : region_ms;
    is_known = true;
}

void TraceCosts::measure_picture(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels, float picture_ms) {
    const double expected = sum(regions, levels);
    if (!(picture_ms > 0) || !std::isfinite(picture_ms) || !(expected > 0)) return;
    bool took_part[kMaxLevels][kRegionKinds] = {};
    for (std::size_t n = 0; n < regions.size(); ++n) took_part[levels[n]][static_cast<std::size_t>(regions[n].kind)] = true;
    const auto factor = static_cast<float>(picture_ms / expected);
    for (std::uint32_t level = 0; level < kMaxLevels; ++level)
        for (std::uint32_t kind = 0; kind < kRegionKinds; ++kind)
            if (took_part[level][kind]) ms[level][kind] *= kMemory + (1 - kMemory) * factor;
}

double TraceCosts::sum(base::Span<const RegionView> regions, base::Span<const std::uint8_t> levels) const {
    TEDAVIS_CHECK(regions.size() == levels.size());
    double all = 0;
    for (std::size_t n = 0; n < regions.size(); ++n) all += of(levels[n], regions[n].kind);
    return all;
}

}  // namespace tedavis::raytrace
