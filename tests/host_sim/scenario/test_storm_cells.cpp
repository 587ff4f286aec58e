#include "host_sim/scenario/storm_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_storm_cells {
namespace {

StormSettings settings() {
    StormSettings storm;
    storm.cells = 8;
    storm.bearing_rad = base::radians(200);
    storm.distance_m = 12'000;
    storm.spread_m = 3'000;
    storm.radius_m = 1'500;
    storm.intensity_dbz = 45;
    storm.intensity_spread_dbz = 6;
    storm.speed_mps = 10;
    storm.speed_spread_mps = 2;
    storm.toward_rad = base::radians(80);
    storm.toward_spread_rad = base::radians(10);
    storm.base_msl_m = 1'500;
    storm.top_msl_m = 8'000;
    return storm;
}

std::vector<StormCell> cells_of(std::uint64_t seed) {
    SeededRandom random(seed);
    return draw_storm_cells(settings(), random);
}

TEST(StormCells, AreDrawnWithinTheirSpreads) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<StormCell> cells = cells_of(seed);
        ASSERT_EQ(cells.size(), 8u);
        for (const StormCell& cell : cells) {
            const double middle_east_m = 12'000 * std::sin(base::radians(200)),
                         middle_north_m = 12'000 * std::cos(base::radians(200));
            EXPECT_LE(std::hypot(cell.east_m - middle_east_m, cell.north_m - middle_north_m), 3'000);
            EXPECT_NEAR(cell.intensity_dbz, 45, 6);
            EXPECT_NEAR(cell.speed_mps, 10, 2);
            EXPECT_NEAR(base::degrees(cell.toward_rad), 80, 10);
            EXPECT_LT(cell.base_msl_m, cell.top_msl_m);
            EXPECT_GT(cell.sigma_dbz, 0);
        }
    }
    EXPECT_NE(cells_of(1)[0].east_m, cells_of(2)[0].east_m);
    EXPECT_NE(cells_of(1)[0].east_m, cells_of(1)[1].east_m);
}

TEST(StormCells, FallToTheirOutlineAndBeyond) {
    const StormCell cell = cells_of(1)[0];
    EXPECT_DOUBLE_EQ(cell.echo_dbz(cell.east_m, cell.north_m, 0), cell.intensity_dbz);
    double mean_dbz = 0;
    constexpr int kRound = 360;
    for (int n = 0; n < kRound; ++n) {
        const double bearing = base::radians(n), away = cell.outline_m(bearing);
        const double echo = cell.echo_dbz(cell.east_m + away * std::sin(bearing), cell.north_m + away * std::cos(bearing), 0);
        EXPECT_NEAR(echo, cell.intensity_dbz - kOutlineDrop_db, SeededWaves::kMax * kTexture_db);
        mean_dbz += echo / kRound;
        EXPECT_GT(away, 1'500 * 0.7 * 0.7);
        EXPECT_LT(away, 1'500 * 1.3 * 1.3);
    }
    EXPECT_NEAR(mean_dbz, cell.intensity_dbz - kOutlineDrop_db, 2 * kTexture_db);
    EXPECT_EQ(cell.echo_dbz(cell.east_m + 50'000, cell.north_m, 0), kNoEcho_dbz);
}

TEST(StormCells, MoveAsAWholeBySpeedTimesTime) {
    for (const StormCell& cell : cells_of(2)) {
        const double gone_m = cell.speed_mps * 600;
        const double east = gone_m * std::sin(cell.toward_rad), north = gone_m * std::cos(cell.toward_rad);
        for (double x = -2'000; x <= 2'000; x += 500)
            EXPECT_NEAR(cell.echo_dbz(cell.east_m + x + east, cell.north_m + 0.3 * x + north, 600),
                        cell.echo_dbz(cell.east_m + x, cell.north_m + 0.3 * x, 0), 1e-6);
    }
}

TEST(StormCells, BecomeAreasThatKnowTheirMotion) {
    const std::vector<StormCell> cells = cells_of(3);
    const LocalPlane plane(base::radians(36.6), base::radians(-84.2));
    const base::Time start{1'780'322'400'000'000'000};
    const LayerDraft layer = make_storm_layer(cells, plane, start);
    EXPECT_EQ(layer.role, scene::LayerRole::storm_cell);
    EXPECT_EQ(layer.data_time_ns, start.ns);
    ASSERT_EQ(layer.feature_count(), cells.size());
    ASSERT_EQ(layer.attributes.size(), 5u);
    EXPECT_EQ(layer.attributes[0].name, "intensity");
    EXPECT_EQ(layer.attributes[2].name, "toward");
    for (std::size_t n = 0; n < cells.size(); ++n) {
        EXPECT_EQ(layer.attributes[0].values[n], static_cast<float>(cells[n].intensity_dbz));
        EXPECT_TRUE(layer.attributes[0].uncertainties[n].is_known());
        EXPECT_EQ(layer.attributes[2].values[n], static_cast<float>(cells[n].toward_rad));
        double north_m = 0;
        for (std::uint32_t point = layer.starts[n]; point < layer.starts[n + 1]; ++point)
            north_m += (layer.points[point].latitude_rad - base::radians(36.6)) / plane.latitude_per_m() /
                       (layer.starts[n + 1] - layer.starts[n]);
        EXPECT_NEAR(north_m, cells[n].north_m, 400) << "its corners stand round its middle";
    }
}

TEST(StormCells, MayBeNone) {
    StormSettings calm = settings();
    calm.cells = 0;
    SeededRandom random(1);
    EXPECT_EQ(make_storm_layer(draw_storm_cells(calm, random), LocalPlane(0, 0), {}).feature_count(), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_storm_cells
