#include "host_sim/scenario/gust_ensemble.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/local_plane.hpp"
#include "host_sim/scenario/seeded_waves.hpp"
#include "host_sim/scenario/square_grid.hpp"
#include "host_sim/scene_builder/ensemble.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kShortestGustWave_m = 12'000, kLongestGustWave_m = 40'000, kGustWaveHeight_m = 3'000;
constexpr std::uint8_t kGustImportance = 110;

class GustMember {
public:
    GustMember(const FlownAir& air, double spread_mps, SeededRandom& random)
        : air_(air),
          spread_mps_(spread_mps),
          offset_(random.within(0, std::sqrt(3.0))),
          waves_(random, kShortestGustWave_m, kLongestGustWave_m, kGustWaveHeight_m) {}

    [[nodiscard]] double at(double east_m, double north_m, double time_s) const {
        const double drift_m = air_.wind_speed_mps * time_s;
        const double wave =
            waves_.at(east_m + drift_m * std::sin(air_.wind_from_rad), north_m + drift_m * std::cos(air_.wind_from_rad), 0);
        const double sigma_mps = spread_mps_ * (1 + std::hypot(east_m, north_m) / kGustDistance_m + time_s / kSecondsPerHour);
        const double off = kAlike * offset_ + std::sqrt(1 - kAlike * kAlike) * wave;
        return std::max(0.0, kGustFactor * air_.wind_speed_mps + sigma_mps * off);
    }

private:
    FlownAir air_;
    double spread_mps_, offset_;
    SeededWaves waves_;
};

LayerDraft empty_gust_layer(const Scenario& scenario, const SquareGrid& square) {
    LayerDraft layer;
    layer.name = "gusts";
    layer.title = "GUST";
    layer.source = kGeneratedOrigin;
    layer.shape = scene::LayerShape::grid;
    layer.role = scene::LayerRole::field;
    layer.importance = kGustImportance;
    const LandingStrip& strip = scenario.strip;
    layer.grid = square.shape(LocalPlane(strip.latitude_rad, strip.longitude_rad), 1, kGustTimes);
    for (int hour = 0; hour < kGustTimes; ++hour) layer.times_ns.push_back(scenario.start.ns + hour * base::kNanosecondsPerHour);
    layer.data_time_ns = scenario.start.ns;
    layer.valid_until_ns = layer.times_ns.back() + base::kNanosecondsPerHour;
    return layer;
}

std::vector<float> values_of(const GustMember& member, const SquareGrid& square) {
    std::vector<float> values;
    for (int hour = 0; hour < kGustTimes; ++hour)
        for (std::uint32_t row = 0; row < kGustPosts; ++row)
            for (std::uint32_t column = 0; column < kGustPosts; ++column)
                values.push_back(
                    static_cast<float>(member.at(square.east_m(column), square.north_m(row), hour * kSecondsPerHour)));
    return values;
}

}  // namespace

LayerDraft make_gust_layer(const Scenario& scenario, const FlownAir& air, SeededRandom& random) {
    const SquareGrid square(scenario.weather->reach_m, kGustPosts);
    const GustSettings& settings = scenario.weather->gust;
    Members members;
    for (int n = 0; n < settings.members; ++n) members.push_back(values_of(GustMember(air, settings.spread_mps, random), square));
    AttributeDraft gust = generated_attribute("gust", "GUST", "m/s", kFullGustSpread_mps);
    gust.uncertainty_growth_per_hour = settings.spread_mps / kFullGustSpread_mps;
    const EnsembleMean joined = mean_of(members);
    for (std::size_t n = 0; n < joined.mean.size(); ++n)
        add_value(gust, static_cast<double>(joined.mean[n]), static_cast<double>(joined.spread[n]));
    std::vector<double> sums;
    add_to_sums(members, sums);
    for (const std::size_t n : evenly_by_rank(sums, members.size())) gust.members.push_back(members[n]);
    LayerDraft layer = empty_gust_layer(scenario, square);
    layer.attributes.push_back(std::move(gust));
    return layer;
}

}  // namespace tedavis::host_sim
