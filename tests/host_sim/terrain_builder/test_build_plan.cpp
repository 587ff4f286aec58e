#include "host_sim/terrain_builder/build_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/expect_user_error.hpp"
#include "tests/support/post_grid.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;
using test_support::post_grid;

TEST(BuildPlan, ARegionIsTakenAsItIs) {
    BuildOptions options;
    options.le90_m = 7;
    const BuildPlan plan = make_build_plan(post_grid(9.6, 47.1, 1.0 / 3600, 2160, 2000), options);
    EXPECT_EQ(plan.header.columns, 2160u);
    EXPECT_EQ(plan.header.rows, 2000u);
    EXPECT_EQ(plan.header.lattice_flags, 0u);
    EXPECT_EQ(plan.header.le90_m, 7);
    EXPECT_STREQ(plan.header.source, "r.tif");
    EXPECT_STREQ(plan.header.vertical_datum, "egm96");
    EXPECT_EQ(plan.levels(), 8u) << "32 * 2^7 cells hold 2159";
    EXPECT_EQ(plan.unit_columns(), 3u);
    EXPECT_EQ(plan.unit_rows(), 2u);
}

TEST(BuildPlan, LevelsGrowUntilOneChunkHoldsAll) {
    for (const auto& [posts, levels] : {std::pair{33u, 1u}, {34u, 2u}, {65u, 2u}, {66u, 3u}, {1025u, 6u}, {1026u, 7u}})
        EXPECT_EQ(make_build_plan(post_grid(0, 10, 0.001, posts, 5), {}).levels(), levels) << posts;
    EXPECT_EQ(make_build_plan(post_grid(0, 1, 0.00001, 1000000, 5), {}).levels(), kMaxLevels);
}

TEST(BuildPlan, RoundTheEarthItCloses) {
    const BuildPlan open = make_build_plan(post_grid(-179.5, 60, 1, 360, 100), {});
    EXPECT_EQ(open.header.columns, 361u);
    EXPECT_EQ(open.source_columns, 360u);
    EXPECT_EQ(open.header.lattice_flags, std::uint32_t{kLatticeClosed});
    const BuildPlan closed = make_build_plan(post_grid(-180, 60, 1, 361, 100), {});
    EXPECT_EQ(closed.header.columns, 361u);
    EXPECT_EQ(closed.source_columns, 360u) << "its closing column is the first one again";
    EXPECT_EQ(make_build_plan(post_grid(-180, 60, 1, 359, 100), {}).header.lattice_flags, 0u);
}

TEST(BuildPlan, PolesGetRows) {
    const BuildPlan cells = make_build_plan(post_grid(-179.5, 89.5, 1, 360, 180), {});
    EXPECT_EQ(cells.header.rows, 182u);
    EXPECT_EQ(cells.first_source_row, 1u);
    EXPECT_EQ(cells.header.north_deg, 89.5);
    EXPECT_TRUE(cells.is_pole_row(0) && cells.is_pole_row(181) && !cells.is_pole_row(1));
    EXPECT_DOUBLE_EQ(base::degrees(cells.lattice.latitude_rad(0)), 90);
    EXPECT_DOUBLE_EQ(base::degrees(cells.lattice.latitude_rad(181)), -90);
    const BuildPlan posts = make_build_plan(post_grid(-180, 90, 1, 361, 181), {});
    EXPECT_EQ(posts.header.rows, 181u) << "the source's own rows at the poles";
    EXPECT_EQ(posts.header.north_deg, 89) << "of row 1";
    EXPECT_EQ(posts.first_source_row, 0u);
    const BuildPlan tile = make_build_plan(post_grid(10, 90, 0.01, 101, 101), {});
    EXPECT_EQ(tile.header.lattice_flags, std::uint32_t{kLatticeNorthPole}) << "a tile that begins at the pole";
    EXPECT_EQ(make_build_plan(post_grid(10, 89.995, 0.01, 101, 101), {}).header.lattice_flags, 0u)
        << "beside the pole, and not round the Earth";
    test_support::expect_user_error([] { (void)make_build_plan(post_grid(0, 91, 1, 20, 20), {}); }, "beyond a pole");
    test_support::expect_user_error([] { (void)make_build_plan(post_grid(0, 50, 1, 1, 20), {}); }, "two by two");
}

TEST(BuildPlan, TolerancesGrowWithTheLevelAndShrinkTowardsThePoles) {
    const BuildPlan plan = make_build_plan(post_grid(-179.5, 89.5, 1, 360, 180), {});
    EXPECT_EQ(plan.header.tolerance_m[0], 0);
    const BuildPlan fine = make_build_plan(post_grid(0, 0.02, 30 / 111320.0, 200, 200), {});
    EXPECT_NEAR(fine.header.tolerance_m[1], 3.75, 0.02) << "an eighth of cells of 30 m";
    EXPECT_NEAR(plan.header.tolerance_m[1] / fine.header.tolerance_m[1], std::pow(111320 / 30.0, 0.6), 1)
        << "less than in proportion";
    for (std::uint32_t level = 2; level < plan.levels(); ++level)
        EXPECT_NEAR(plan.header.tolerance_m[level] / plan.header.tolerance_m[level - 1], 2.5, 1e-6);
    EXPECT_NEAR(plan.tolerance_m(1, 1), plan.header.tolerance_m[1], 0.1 * plan.header.tolerance_m[1]) << "at the equator";
    EXPECT_LT(plan.tolerance_m(1, 0), 0.75 * plan.header.tolerance_m[1]) << "the chunk at the pole";
    // The root of the area of rows 0 to 64, 90 to 26 degrees north, per angle.
    const double expected = std::sqrt((1 - std::sin(base::radians(26.5))) / base::radians(63.5));
    EXPECT_NEAR(plan.tolerance_m(1, 0) / plan.header.tolerance_m[1], expected, 1e-6);
}

TEST(BuildPlan, TheVertexGridHoldsWhatAFloatHolds) {
    for (const double step : {1.0 / 3600, 1.0 / 120, 0.25, 2.0}) {
        const BuildPlan plan = make_build_plan(post_grid(-170, 80, step, 150, 60), {});
        for (std::uint32_t level = 0; level < plan.levels(); ++level) {
            const double q = plan.quantum_m(level);
            EXPECT_EQ(std::exp2(std::round(std::log2(q))), q) << "a power of two";
            EXPECT_GE(q, 1.0 / 1024);
            const double reach_m = std::min(5000 + 0.5 * std::sqrt(2.0) * plan.cell_m * (kChunkCells << level), 12.8e6);
            EXPECT_LE(reach_m / q, 16777216) << "24 bits";
            EXPECT_GE(q, plan.quantum_m(level == 0 ? 0 : level - 1));
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim
