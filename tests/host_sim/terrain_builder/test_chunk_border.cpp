#include "host_sim/terrain_builder/chunk_border.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_chunk_border {
namespace {

using namespace terrain;
using test_support::BuildGround;

bool is_corner(const PostRange& posts, const BorderPost& p) {
    return (p.i == posts.i0 || p.i == posts.i1) && (p.j == posts.j0 || p.j == posts.j1);
}

TEST(ChunkBorder, RunsClockwiseFromTheNorthWestCornerAndKeepsCorners) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    for (std::uint32_t level = 0; level < ground.plan.levels(); ++level)
        for (std::uint32_t j = 0; j < ground.plan.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < ground.plan.lattice.grid_columns(level); ++i) {
                const PostRange posts = ground.plan.lattice.posts_of({level, i, j});
                const std::vector<BorderPost> border = chunk_border(ground.plan, ground.lines, {level, i, j});
                EXPECT_TRUE(border[0].i == posts.i0 && border[0].j == posts.j0);
                int corners = 0;
                std::int64_t twice_area = 0;
                for (std::size_t n = 0; n < border.size(); ++n) {
                    const BorderPost &a = border[n], &b = border[(n + 1) % border.size()];
                    twice_area += std::int64_t{a.i} * b.j - std::int64_t{b.i} * a.j;
                    corners += is_corner(posts, a) ? 1 : 0;
                    EXPECT_TRUE(!is_corner(posts, a) || a.stays);
                    EXPECT_GE(a.top_level, level);
                }
                EXPECT_EQ(corners, 4);
                EXPECT_EQ(twice_area, 2 * std::int64_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0)) << "i east, j south";
            }
}

TEST(ChunkBorder, AllPostsStayOnSidesBetweenSiblings) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    int passing = 0;
    for (const BorderPost& p : chunk_border(ground.plan, ground.lines, {1, 1, 1})) {
        EXPECT_TRUE(p.stays || (p.i != 64 && p.j != 64));
        passing += p.i == 128 && !p.stays ? 1 : 0;
    }
    EXPECT_GT(passing, 0);
}

TEST(ChunkBorder, CoarserNeighboursLieBeyondSidesOfTheParentOnly) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    EXPECT_EQ(sides_of_parent(ground.plan, {0, 0, 0}), 0) << "two sides end the lattice, two are between siblings";
    EXPECT_EQ(sides_of_parent(ground.plan, {0, 1, 1}), kEdgeEast | kEdgeSouth);
    EXPECT_EQ(sides_of_parent(ground.plan, {0, 2, 3}), kEdgeWest | kEdgeSouth);
    EXPECT_EQ(sides_of_parent(ground.plan, {ground.plan.levels() - 1, 0, 0}), 0);
    const BuildGround earth(test_support::make_earth_raster(2.5));
    EXPECT_EQ(sides_of_parent(earth.plan, {0, 0, 1}), kEdgeWest | kEdgeSouth) << "round the Earth it goes on";
    EXPECT_EQ(sides_of_parent(earth.plan, {0, 4, 1}), kEdgeEast | kEdgeWest | kEdgeSouth) << "cut off by the closing column";
}

TEST(ChunkBorder, APoleIsOnTheCoarsestGrid) {
    const BuildGround earth(test_support::make_earth_raster(2.5));
    for (const BorderPost& p : chunk_border(earth.plan, earth.lines, {0, 1, 0}))
        EXPECT_TRUE(p.j != 0 || p.top_level == earth.plan.levels() - 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_border
