#include "host_sim/terrain_builder/build_plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_build_plan {
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

/// Every row of the source stands at its own latitude, whatever rows the poles have been given; a row at a pole is one place.
TEST(BuildPlan, RowsOfTheSourceKeepTheirLatitudesBesideRowsAtThePoles) {
    struct Case {
        const char* name;
        PostGrid grid;
        std::uint32_t rows, first_source_row, flags;
    };
    constexpr std::uint32_t kRound = kLatticeClosed, kNorth = kLatticeNorthPole, kSouth = kLatticeSouthPole;
    for (const Case& c :
         {Case{"cells, half a step from both", post_grid(-179.5, 89.5, 1, 360, 180), 182, 1, kRound | kNorth | kSouth},
          Case{"posts on both", post_grid(-180, 90, 1, 361, 181), 181, 0, kRound | kNorth | kSouth},
          Case{"a step from both", post_grid(-180, 89, 1, 360, 179), 181, 1, kRound | kNorth | kSouth},
          Case{"more than a step from both", post_grid(-180, 88.9, 1, 360, 178), 178, 0, kRound},
          Case{"on the north pole alone", post_grid(0, 90, 0.5, 720, 101), 101, 0, kRound | kNorth},
          Case{"beside the south pole alone", post_grid(0, 10.75, 0.5, 721, 202), 203, 0, kRound | kSouth},
          Case{"a tile on the south pole", post_grid(20, -80, 0.25, 41, 41), 41, 0, kSouth},
          Case{"a tile a step from the south pole", post_grid(20, -79.75, 0.25, 41, 41), 41, 0, 0}}) {
        SCOPED_TRACE(c.name);
        const BuildPlan plan = make_build_plan(c.grid, {});
        EXPECT_EQ(plan.header.rows, c.rows);
        EXPECT_EQ(plan.first_source_row, c.first_source_row);
        EXPECT_EQ(plan.header.lattice_flags, c.flags);
        for (std::uint32_t row = 0; row < c.grid.rows; ++row)
            EXPECT_NEAR(base::degrees(plan.lattice.latitude_rad(row + plan.first_source_row)),
                        c.grid.north_deg - row * c.grid.step_lat_deg, 1e-12);
        for (std::uint32_t j = 0; j + 1 < plan.header.rows; ++j)
            EXPECT_GT(plan.lattice.latitude_rad(j), plan.lattice.latitude_rad(j + 1)) << j;
        for (std::uint32_t j = 0; j < plan.header.rows; ++j) {
            EXPECT_EQ(plan.is_pole_row(j), std::abs(plan.lattice.latitude_rad(j)) > base::radians(90 - 1e-9)) << j;
            const glm::dvec3 first = plan.lattice.position(0, j, 0), other = plan.lattice.position(plan.header.columns / 3, j, 0);
            EXPECT_EQ(glm::length(first - other) < 1e-6, plan.is_pole_row(j)) << j;
        }
    }
}

/// Round the Earth the lattice is 360 degrees wide, its last column is its first, and no other two columns share a meridian.
TEST(BuildPlan, ALatticeRoundTheEarthIsAsWideAsTheEarth) {
    constexpr double kStep_deg = 360.0 / 1079;  // no sum of binary fractions
    for (const PostGrid& grid :
         {post_grid(-179.5, 60, 1, 360, 5), post_grid(-180, 60, 1, 361, 5), post_grid(3, 90, kStep_deg, 1079, 20),
          post_grid(-0.1, 60, kStep_deg, 1080, 5), post_grid(0, 60, 120, 3, 2), post_grid(0, 60, 1 + 2e-6, 360, 5)}) {
        SCOPED_TRACE(grid.step_lon_deg);
        const BuildPlan plan = make_build_plan(grid, {});
        const std::uint32_t last = plan.header.columns - 1;
        ASSERT_TRUE(plan.lattice.is_closed());
        EXPECT_DOUBLE_EQ(plan.header.step_lon_deg * last, 360);
        EXPECT_EQ(plan.source_columns, last) << "each meridian of the source once";
        EXPECT_EQ(plan.lattice.longitude_rad(last), plan.lattice.longitude_rad(0));
        EXPECT_EQ(plan.lattice.position(last, 1, 7), plan.lattice.position(0, 1, 7));
        for (std::uint32_t i = 0; i < last; ++i)
            EXPECT_NEAR(base::degrees(plan.lattice.longitude_rad(i)), grid.west_deg + i * grid.step_lon_deg,
                        1e-3 * grid.step_lon_deg);
    }
    for (const PostGrid& grid : {post_grid(0, 60, 1, 359, 5), post_grid(0, 60, 1, 362, 5), post_grid(0, 60, 1.0001, 360, 5)}) {
        const BuildPlan plan = make_build_plan(grid, {});
        EXPECT_FALSE(plan.lattice.is_closed()) << grid.columns << " of " << grid.step_lon_deg;
        EXPECT_EQ(plan.header.columns, grid.columns);
        EXPECT_EQ(plan.header.step_lon_deg, grid.step_lon_deg);
    }
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

/// Half the extents of a chunk, from its own corners, edges and inner posts at the lowest and the highest height, `parts` and one
/// more each way: places by doubles.
double farthest_of(const BuildPlan& plan, const ChunkKey& key, std::uint32_t parts = 2) {
    const PostRange posts = plan.lattice.posts_of(key);
    const earth::Geodetic middle{0.5 * (plan.lattice.latitude_rad(posts.j0) + plan.lattice.latitude_rad(posts.j1)),
                                 plan.lattice.longitude_rad((posts.i0 + posts.i1) / 2),
                                 {0}};
    const glm::dmat3 axes = earth::north_east_down(middle.latitude_rad, middle.longitude_rad);
    std::vector<glm::dvec3> places;
    for (std::uint32_t b = 0; b <= parts; ++b)
        for (std::uint32_t a = 0; a <= parts; ++a)
            for (const double sign : {-1.0, 1.0})
                places.push_back(plan.lattice.position(posts.i0 + (posts.i1 - posts.i0) * a / parts,
                                                       posts.j0 + (posts.j1 - posts.j0) * b / parts,
                                                       1000 + sign * plan.half_relief_m));
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

/// Beside a pole chunks are wedges and discs: posts all over each of them, at both heights, must lie as near as was planned.
TEST(BuildPlan, TheVertexGridHoldsChunksAtThePoles) {
    for (const PostGrid& grid :
         {post_grid(-179, 89, 2, 180, 90), post_grid(-180, 90, 2.5, 145, 73), post_grid(0, 90, 0.5, 720, 40),
          post_grid(10, 90, 0.01, 101, 101), post_grid(-60, -89, 0.01, 90, 101)}) {
        BuildPlan plan = make_build_plan(grid, {});
        ASSERT_TRUE(plan.has_north_pole() || plan.has_south_pole());
        plan.know_heights(-400, 8800);
        for (std::uint32_t level = 0; level < plan.levels(); ++level) {
            double farthest = 0;
            for (std::uint32_t j = 0; j < plan.lattice.grid_rows(level); ++j)
                for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i)
                    farthest = std::max(farthest, farthest_of(plan, {level, i, j}, 16));
            EXPECT_GT(farthest, plan.half_relief_m);
            EXPECT_LE(farthest, plan.farthest_vertex_m(level)) << grid.north_deg << " " << grid.step_lat_deg << " " << level;
            EXPECT_LE(plan.farthest_vertex_m(level) / plan.quantum_m(level), 16777216) << "24 bits";
        }
    }
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
}  // namespace tedavis::host_sim::test_build_plan
