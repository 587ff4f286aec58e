#include "host_sim/scenario/radar_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/square_grid.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::int64_t kInterval_ns = kRadarInterval_s * std::int64_t{1'000'000'000};
constexpr int kValidIntervals = 3;
constexpr double kGrowth_per_hour = 0.6;
constexpr std::uint8_t kRadarImportance = 150;

int frames_until(double duration_s) {
    return std::min(kMaxRadarFrames, 1 + static_cast<int>(std::ceil(duration_s / kRadarInterval_s)));
}

double strongest_dbz(const std::vector<StormCell>& cells, double east_m, double north_m, double time_s) {
    double strongest = kNoEcho_dbz;
    for (const StormCell& cell : cells) strongest = std::max(strongest, cell.echo_dbz(east_m, north_m, time_s));
    return strongest;
}

LayerDraft empty_radar_layer(const Scenario& scenario, const SquareGrid& square, int frames) {
    LayerDraft layer;
    layer.name = "radar";
    layer.title = "RADAR";
    layer.source = kGeneratedOrigin;
    layer.shape = scene::LayerShape::grid;
    layer.role = scene::LayerRole::field;
    layer.importance = kRadarImportance;
    const LandingStrip& strip = scenario.strip;
    layer.grid = square.shape(LocalPlane(strip.latitude_rad, strip.longitude_rad), 1, static_cast<std::uint32_t>(frames));
    for (int frame = 0; frame < frames; ++frame) layer.times_ns.push_back(scenario.start.ns + frame * kInterval_ns);
    layer.data_time_ns = layer.times_ns.back();  // all of it is measured, nothing forecast
    layer.valid_until_ns = layer.times_ns.back() + kValidIntervals * kInterval_ns;
    return layer;
}

}  // namespace

LayerDraft make_radar_layer(const Scenario& scenario, const std::vector<StormCell>& cells, base::Time flight_end) {
    const int frames = frames_until((flight_end - scenario.start).to_seconds());
    const SquareGrid square(scenario.weather->reach_m, kRadarPosts);
    LayerDraft layer = empty_radar_layer(scenario, square, frames);
    AttributeDraft echo = generated_attribute("reflectivity", "RADAR", "dBZ", 0);
    echo.uncertainty_kind = scene::UncertaintyKind::ordinal;
    echo.uncertainty_full = 1;
    echo.uncertainty_growth_per_hour = kGrowth_per_hour;
    for (int frame = 0; frame < frames; ++frame)
        for (std::uint32_t row = 0; row < kRadarPosts; ++row)
            for (std::uint32_t column = 0; column < kRadarPosts; ++column) {
                const double x = square.east_m(column), y = square.north_m(row);
                const double share = std::hypot(x, y) / scenario.weather->radar_range_m;
                const bool is_seen = share <= 1;
                echo.values.push_back(is_seen ? static_cast<float>(strongest_dbz(cells, x, y, frame * kRadarInterval_s))
                                              : std::numeric_limits<float>::quiet_NaN());
                echo.uncertainties.push_back(is_seen ? scene::Uncertainty::from_level(kQualityLost * share * share)
                                                     : scene::Uncertainty());
            }
    layer.attributes.push_back(std::move(echo));
    return layer;
}

}  // namespace tedavis::host_sim
