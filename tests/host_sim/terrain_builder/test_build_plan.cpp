#include "host_sim/terrain_builder/build_plan.hpp"

#include <gtest/gtest.h>

#include <array>
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

/// Half the extents of a chunk, from its own corners, edges and middle at the lowest and the highest height: places by doubles.
double farthest_of(const BuildPlan& plan, const ChunkKey& key) {
    const PostRange posts = plan.lattice.posts_of(key);
    const earth::Geodetic middle{0.5 * (plan.lattice.latitude_rad(posts.j0) + plan.lattice.latitude_rad(posts.j1)),
                                 plan.lattice.longitude_rad((posts.i0 + posts.i1) / 2),
                                 {0}};
    const glm::dmat3 axes = earth::north_east_down(middle.latitude_rad, middle.longitude_rad);
    std::vector<glm::dvec3> places;
    for (const std::uint32_t j : {posts.j0, (posts.j0 + posts.j1) / 2, posts.j1})
        for (const std::uint32_t i : {posts.i0, (posts.i0 + posts.i1) / 2, posts.i1})
            for (const double sign : {-1.0, 1.0}) places.push_back(plan.lattice.position(i, j, 1000 + sign * plan.half_relief_m));
    glm::dvec3 least(1e9), most(-1e9);
    for (const glm::dvec3& place : places)
        for (int a = 0; a < 3; ++a) {
            least[a] = std::min(least[a], glm::dot(place, axes[a]));
            most[a] = std::max(most[a], glm::dot(place, axes[a]));
        }
    const glm::dvec3 centre = axes * (0.5 * (least + most));
    double farthest = 0;
    for (const glm::dvec3& place : places)
        for (int a = 0; a < 3; ++a) farthest = std::max(farthest, std::abs(place[a] - centre[a]) + 1);
    return farthest;
}

TEST(BuildPlan, TheVertexGridHoldsWhatAFloatHolds) {
    int tight = 0, all = 0;
    for (const auto& [west, north, step] : {std::array{9.0, 47.0, 1.0 / 3600},
                                            {-84.4, 36.7, 1.0 / 1200},
                                            {-170.0, 79.9, 1.0 / 600},
                                            {-3.0, 5.0, 1.0 / 120},
                                            {179.0, -40.0, 1.0 / 1200},
                                            {44.9, 0.1, 0.05},
                                            {-170.0, 80.0, 0.25},
                                            {-170.0, 80.0, 2.0}})
        for (const double highest_m : {200.0, 9000.0}) {
            BuildPlan plan = make_build_plan(post_grid(west, north, step, 150, 70), {});
            plan.know_heights(0, highest_m);
            for (std::uint32_t level = 0; level < plan.levels(); ++level) {
                const double q = plan.quantum_m(level);
                EXPECT_EQ(std::exp2(std::round(std::log2(q))), q) << "a power of two";
                EXPECT_GE(q, 1.0 / 16384);
                EXPECT_LE(plan.farthest_vertex_m(level) / q, 16777216) << "24 bits";
                EXPECT_GE(q, plan.quantum_m(level == 0 ? 0 : level - 1));
                double farthest = 0;
                for (std::uint32_t j = 0; j < plan.lattice.grid_rows(level); ++j)
                    for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i)
                        farthest = std::max(farthest, farthest_of(plan, {level, i, j}));
                EXPECT_LE(farthest, plan.farthest_vertex_m(level)) << west << " " << north << " " << step << " " << level;
                tight += farthest > 0.75 * plan.farthest_vertex_m(level) ? 1 : 0;
                ++all;
            }
        }
    EXPECT_GT(tight, all / 2) << "finer than it would be for any place on the Earth";
}

TEST(BuildPlan, KnownHeightsMakeTheVertexGridFiner) {
    BuildPlan plan = make_build_plan(post_grid(-84.4, 36.7, 1.0 / 1200, 300, 300), {});
    const double unknown = plan.quantum_m(0);
    plan.know_heights(200, 1100);
    EXPECT_LT(plan.quantum_m(0), unknown);
    plan.know_heights(-400, 8800);
    EXPECT_GE(plan.quantum_m(0), 4400 / 16777216.0);
}

}  // namespace
}  // namespace tedavis::host_sim
