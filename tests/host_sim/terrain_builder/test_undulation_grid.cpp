#include "host_sim/terrain_builder/undulation_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::host_sim::test_undulation_grid {
namespace {

using test_support::post_grid;

TEST(UndulationGrid, IsTheGeoidBetweenItsNodes) {
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const UndulationGrid grid = UndulationGrid::covering(9.63, 46.51, 10.2, 47.09, geoid);
    EXPECT_EQ(grid.west_deg, 9.5);
    EXPECT_EQ(grid.north_deg, 47.25);
    EXPECT_EQ(grid.columns, 4u);
    EXPECT_EQ(grid.rows, 4u);
    for (double lat = 46.51; lat < 47.09; lat += 0.037)
        for (double lon = 9.63; lon < 10.2; lon += 0.041)
            EXPECT_NEAR(grid.at(lat, lon), geoid.undulation(base::radians(lat), base::radians(lon)).m, 1e-5);
    EXPECT_EQ(grid.at(60, 10), grid.at(47.25, 10)) << "places outside take the nearest node's";
}

TEST(PostUndulation, IsTheSameInEveryWindow) {
    const BuildPlan plan = make_build_plan(post_grid(9.6, 47.1, 0.01, 50, 40), {});
    const PostUndulation undulation(plan.undulation, plan.lattice);
    std::vector<double> all, part;
    undulation.row(0, 50, 17, all);
    undulation.row(13, 20, 17, part);
    for (std::size_t n = 0; n < 20; ++n) EXPECT_EQ(part[n], all[13 + n]);
}

TEST(PostUndulation, ClosesRoundTheEarthAndHasOneValueAtAPole) {
    const BuildPlan plan = make_build_plan(post_grid(-179, 89, 2, 180, 90), {});
    const PostUndulation undulation(plan.undulation, plan.lattice);
    std::vector<double> row;
    undulation.row(-3, 190, 20, row);
    EXPECT_EQ(row[3], row[183]) << "the closing column";
    EXPECT_EQ(row[0], row[180]) << "before the first column lies the last but one";
    EXPECT_EQ(row[185], row[5]);
    undulation.row(0, 181, 0, row);
    for (const double value : row) EXPECT_EQ(value, row[0]);
    EXPECT_NEAR(row[0], GeoidEgm96::installed().undulation(base::kPi / 2, 0).m, 1e-4);
}

}  // namespace
}  // namespace tedavis::host_sim::test_undulation_grid
