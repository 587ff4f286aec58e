#include "render_core/draw/terrain_bands.hpp"

namespace tedavis::draw {
namespace {

constexpr float kNever_m = 1e9f;

}  // namespace

TerrainBands::TerrainBands() : color{} {
    for (float& limit : lower_m) limit = kNever_m;
}

TerrainBands bands_within(const design::WarningBands& bands, double aircraft_msl_m, bool gear_down, float least_height_m,
                          float greatest_height_m) {
    TerrainBands within;
    for (std::size_t left = bands.size(); left > 0; --left) {
        const design::WarningBand& band = bands[left - 1];
        const auto lower = static_cast<float>(aircraft_msl_m + (gear_down ? band.lower_gear_down_m : band.lower_m));
        if (lower > greatest_height_m) continue;
        if (lower <= least_height_m) within.count = 0;  // holds everywhere: what lies below it is never seen
        within.lower_m[within.count] = lower;
        float* color = within.color + 4 * within.count++;
        color[0] = static_cast<float>(band.color.red) / 255.0f;
        color[1] = static_cast<float>(band.color.green) / 255.0f;
        color[2] = static_cast<float>(band.color.blue) / 255.0f;
        color[3] = static_cast<float>(band.strength);
    }
    for (std::size_t n = within.count; n < design::kMaxWarningBands; ++n) within.lower_m[n] = kNever_m;
    return within;
}

}  // namespace tedavis::draw
