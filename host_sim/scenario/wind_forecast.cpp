#include "host_sim/scenario/wind_forecast.hpp"

#include <cmath>

#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/local_plane.hpp"
#include "host_sim/scenario/seeded_waves.hpp"
#include "host_sim/scenario/square_grid.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kShortestWindWave_m = 10'000, kLongestWindWave_m = 40'000, kWindWaveHeight_m = 3'000;
constexpr double kPower = 1.0 / 7;
constexpr std::uint8_t kWindImportance = 120;

/// East and north vary on their own.
class WindField {
public:
    WindField(const Scenario& scenario, const FlownAir& air, SeededRandom& random)
        : settings_(scenario.weather->wind),
          latitude_rad_(scenario.strip.latitude_rad),
          air_(air),
          east_(random, kShortestWindWave_m, kLongestWindWave_m, kWindWaveHeight_m),
          north_(random, kShortestWindWave_m, kLongestWindWave_m, kWindWaveHeight_m) {}

    [[nodiscard]] MeanWind at(double east_m, double north_m, double height_m, double time_s) const {
        const MeanWind mean = mean_wind(air_, latitude_rad_, height_m);
        const double distance = std::hypot(east_m, north_m) / kStationReach_m;
        const double strength_mps = settings_.variation_mps * (1 - std::exp(-distance * distance));
        const double x = east_m - mean.east_mps * time_s, y = north_m - mean.north_mps * time_s;
        return {mean.east_mps + strength_mps * east_.at(x, y, height_m),
                mean.north_mps + strength_mps * north_.at(x, y, height_m)};
    }
    [[nodiscard]] double sigma_mps(double east_m, double north_m, double time_s) const {
        return settings_.sigma_mps * (1 + std::hypot(east_m, north_m) / kSigmaDistance_m + time_s / kSecondsPerHour);
    }

private:
    WindSettings settings_;
    double latitude_rad_;
    FlownAir air_;
    SeededWaves east_, north_;
};

LayerDraft empty_wind_layer(const Scenario& scenario, const SquareGrid& square) {
    LayerDraft layer;
    layer.name = "wind";
    layer.title = "WIND";
    layer.source = kGeneratedOrigin;
    layer.shape = scene::LayerShape::grid;
    layer.role = scene::LayerRole::wind;
    layer.importance = kWindImportance;
    const LandingStrip& strip = scenario.strip;
    layer.grid = square.shape(LocalPlane(strip.latitude_rad, strip.longitude_rad), kWindHeights_m.size(), kWindTimes);
    for (const double height_m : kWindHeights_m) layer.levels_m.push_back(static_cast<float>(strip.elevation_msl_m + height_m));
    for (int hour = 0; hour < kWindTimes; ++hour) layer.times_ns.push_back(scenario.start.ns + hour * base::kNanosecondsPerHour);
    layer.data_time_ns = scenario.start.ns;
    layer.valid_until_ns = layer.times_ns.back() + base::kNanosecondsPerHour;
    return layer;
}

}  // namespace

MeanWind mean_wind(const FlownAir& air, double strip_latitude_rad, double height_m) {
    const double speed_mps = air.wind_speed_mps * std::pow(height_m / kWindReference_m, kPower);
    const double turn_rad = kVeer_rad * (std::exp(-kWindReference_m / kVeerHeight_m) - std::exp(-height_m / kVeerHeight_m));
    const double from_rad = air.wind_from_rad + std::copysign(turn_rad, turn_rad * strip_latitude_rad);
    return {-speed_mps * std::sin(from_rad), -speed_mps * std::cos(from_rad)};
}

LayerDraft make_wind_layer(const Scenario& scenario, const FlownAir& air, SeededRandom& random) {
    const SquareGrid square(scenario.weather->reach_m, kWindPosts);
    const WindField field(scenario, air, random);
    LayerDraft layer = empty_wind_layer(scenario, square);
    AttributeDraft east = generated_attribute("east", "WIND EAST", "m/s", kFullWindSigma_mps);
    AttributeDraft north = generated_attribute("north", "WIND NORTH", "m/s", kFullWindSigma_mps);
    AttributeDraft speed = generated_attribute("speed", "WIND SPEED", "m/s", kFullWindSigma_mps);
    for (int hour = 0; hour < kWindTimes; ++hour)
        for (const double height_m : kWindHeights_m)
            for (std::uint32_t row = 0; row < kWindPosts; ++row)
                for (std::uint32_t column = 0; column < kWindPosts; ++column) {
                    const double x = square.east_m(column), y = square.north_m(row);
                    const MeanWind wind = field.at(x, y, height_m, hour * kSecondsPerHour);
                    const double sigma_mps = field.sigma_mps(x, y, hour * kSecondsPerHour);
                    add_value(east, wind.east_mps, sigma_mps);
                    add_value(north, wind.north_mps, sigma_mps);
                    add_value(speed, std::hypot(wind.east_mps, wind.north_mps), sigma_mps);
                }
    for (AttributeDraft* attribute : {&east, &north, &speed}) {
        attribute->uncertainty_growth_per_hour = scenario.weather->wind.sigma_mps / kFullWindSigma_mps;
        layer.attributes.push_back(std::move(*attribute));
    }
    return layer;
}

}  // namespace tedavis::host_sim
