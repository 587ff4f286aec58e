#include "host_sim/scenario/radar_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "host_sim/scenario/square_grid.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_radar_frames {
namespace {

constexpr std::size_t kFrame = kRadarPosts * kRadarPosts;

Scenario shipped() {
    return parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
}

std::vector<StormCell> cells_of(const Scenario& scenario, int count) {
    StormSettings settings = scenario.weather->storm;
    settings.cells = count;
    settings.spread_m = 0;
    SeededRandom random(5);
    return draw_storm_cells(settings, random);
}

LayerDraft frames(const Scenario& scenario, const std::vector<StormCell>& cells, double duration_s) {
    return make_radar_layer(scenario, cells, scenario.start + base::Duration::from_seconds(duration_s));
}

struct Middle {
    double east_m = 0, north_m = 0;
};
/// Of the echo above a threshold, weighted by how much it is above.
Middle middle_of(const LayerDraft& layer, double reach_m, std::size_t frame) {
    const SquareGrid square(reach_m, kRadarPosts);
    Middle sum;
    double weights = 0;
    for (std::uint32_t row = 0; row < kRadarPosts; ++row)
        for (std::uint32_t column = 0; column < kRadarPosts; ++column) {
            const float dbz = layer.attributes[0].values[frame * kFrame + row * kRadarPosts + column];
            const double weight = dbz > 25 ? static_cast<double>(dbz) - 25 : 0;
            sum.east_m += weight * square.east_m(column);
            sum.north_m += weight * square.north_m(row);
            weights += weight;
        }
    return {sum.east_m / weights, sum.north_m / weights};
}

TEST(RadarFrames, ShowACellThatMovesBySpeedTimesTime) {
    Scenario scenario = shipped();
    scenario.weather->storm.distance_m = 8000;  // so that the radar sees the whole cell at each time
    const std::vector<StormCell> cells = cells_of(scenario, 1);
    const LayerDraft layer = frames(scenario, cells, 370);
    ASSERT_EQ(layer.times_ns.size(), 3u);
    for (std::size_t frame = 0; frame < 2; ++frame) {
        const double seconds = 1e-9 * static_cast<double>(layer.times_ns[frame + 1] - layer.times_ns[frame]);
        EXPECT_EQ(seconds, 300);
        const Middle a = middle_of(layer, scenario.weather->reach_m, frame),
                     b = middle_of(layer, scenario.weather->reach_m, frame + 1);
        EXPECT_NEAR(b.east_m - a.east_m, cells[0].speed_mps * std::sin(cells[0].toward_rad) * seconds, 60);
        EXPECT_NEAR(b.north_m - a.north_m, cells[0].speed_mps * std::cos(cells[0].toward_rad) * seconds, 60);
    }
}

TEST(RadarFrames, SeeNothingBeyondTheRangeAndAreLessSureTowardsIt) {
    const Scenario scenario = shipped();
    const LayerDraft layer = frames(scenario, cells_of(scenario, 2), 370);
    const AttributeDraft& echo = layer.attributes[0];
    const SquareGrid square(scenario.weather->reach_m, kRadarPosts);
    ASSERT_EQ(echo.values.size(), 3 * kFrame);
    for (std::size_t n = 0; n < echo.values.size(); ++n) {
        const double away_m = std::hypot(square.east_m(n % kRadarPosts), square.north_m(n % kFrame / kRadarPosts));
        const bool is_seen = away_m <= scenario.weather->radar_range_m;
        ASSERT_EQ(std::isnan(echo.values[n]), !is_seen);
        ASSERT_EQ(echo.uncertainties[n].is_known(), is_seen);
        if (!is_seen) continue;
        ASSERT_GE(echo.values[n], kNoEcho_dbz);
        const double share = away_m / scenario.weather->radar_range_m;
        ASSERT_NEAR(echo.uncertainties[n].level(), 0.7 * share * share, 1.0 / 254);
    }
    float strongest = static_cast<float>(kNoEcho_dbz);
    for (std::size_t n = 0; n < kFrame; ++n) strongest = std::fmax(strongest, echo.values[n]);
    EXPECT_GT(strongest, 35);
}

TEST(RadarFrames, CoverTheFlightUpToAnEnd) {
    const Scenario scenario = shipped();
    EXPECT_EQ(frames(scenario, {}, 1).times_ns.size(), 2u);
    EXPECT_EQ(frames(scenario, {}, 600).times_ns.size(), 3u);
    EXPECT_EQ(frames(scenario, {}, 601).times_ns.size(), 4u);
    EXPECT_EQ(frames(scenario, {}, 1e5).times_ns.size(), static_cast<std::size_t>(kMaxRadarFrames));
}

TEST(RadarFrames, SeeNoEchoOfNoStorm) {
    const Scenario scenario = shipped();
    const LayerDraft layer = frames(scenario, {}, 100);
    for (const float value : layer.attributes[0].values)
        EXPECT_TRUE(std::isnan(value) || value == static_cast<float>(kNoEcho_dbz));
}

}  // namespace
}  // namespace tedavis::host_sim::test_radar_frames
