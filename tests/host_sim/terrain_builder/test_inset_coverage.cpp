#include "host_sim/terrain_builder/inset_coverage.hpp"

#include <gtest/gtest.h>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::host_sim::test_inset_coverage {
namespace {

using namespace terrain;

/// 200 x 150 coarse posts, `levels` finer levels below them.
BuildPlan fine_plan(std::uint32_t levels) {
    return make_finer_plan(make_build_plan(test_support::post_grid(0, 40, 0.01, 200, 150), {}, levels), levels);
}

template <class Action>
void for_existing(const BuildPlan& plan, const InsetCoverage& coverage, Action action) {
    for (std::uint32_t level = 0; level < plan.levels(); ++level)
        for (std::uint32_t j = 0; j < plan.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i)
                if (coverage.exists({level, i, j})) action(ChunkKey{level, i, j});
}

void expect_balanced_tree(const BuildPlan& plan, const InsetCoverage& coverage) {
    std::int64_t exact_area = 0;
    for_existing(plan, coverage, [&](const ChunkKey& key) {
        if (key.level + 1 < plan.levels()) {
            EXPECT_TRUE(coverage.exists(key.parent()));
            EXPECT_TRUE(coverage.has_children(key.parent()));
        }
        for (std::uint32_t quadrant = 0; key.level > 0 && quadrant < 4; ++quadrant)
            EXPECT_TRUE(!plan.lattice.contains(key.child(quadrant)) ||
                        coverage.exists(key.child(quadrant)) == coverage.has_children(key));
        if (!coverage.is_exact(key)) return;
        const PostRange posts = plan.lattice.posts_of(key);
        exact_area += std::int64_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0);
        // No neighbour of an exact chunk goes down by more than one level.
        for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
            const ChunkKey beside = plan.lattice.neighbour(key, side);
            if (beside == kNoChunk || !coverage.exists(beside) || !coverage.has_children(beside)) continue;
            for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
                const ChunkKey child = beside.child(quadrant);
                const bool faces = side == kEdgeNorth   ? quadrant >= 2
                                   : side == kEdgeSouth ? quadrant < 2
                                   : side == kEdgeWest  ? quadrant % 2 == 1
                                                        : quadrant % 2 == 0;
                EXPECT_FALSE(faces && plan.lattice.contains(child) && coverage.has_children(child)) << key.level;
            }
        }
    });
    EXPECT_EQ(exact_area, std::int64_t{plan.header.columns - 1} * (plan.header.rows - 1)) << "exact chunks fill the lattice once";
}

TEST(InsetCoverage, WithoutInsetsEverythingExists) {
    const BuildPlan plan = fine_plan(0);
    const InsetCoverage none;
    expect_balanced_tree(plan, none);
    EXPECT_TRUE(none.is_exact({0, 1, 1}));
    EXPECT_TRUE(none.regions().empty());
}

TEST(InsetCoverage, IsABalancedTreeAroundInsets) {
    for (std::uint32_t levels = 1; levels <= kMaxBaseLevel; ++levels) {
        const BuildPlan plan = fine_plan(levels);
        const std::uint32_t side = 1u << levels;
        const InsetCoverage one(plan.lattice, levels, {{60 * side + 3, 50 * side, 80 * side, 61 * side + 1}});
        expect_balanced_tree(plan, one);
        EXPECT_TRUE(one.is_exact({0, 70 * side / 32, 55 * side / 32})) << "in the inset";
        EXPECT_TRUE(one.is_exact({levels, 5, 4})) << "far away";
        const InsetCoverage two(
            plan.lattice, levels,
            {{10 * side, 5 * side, 20 * side, 9 * side}, {18 * side, 100 * side, 30 * side, 110 * side}, {0, 0, 5, 5}});
        expect_balanced_tree(plan, two);
    }
}

TEST(InsetCoverage, RegionsHoldAllFineChunksAndKeepApart) {
    const BuildPlan plan = fine_plan(3);
    const InsetCoverage coverage(plan.lattice, 3, {{40, 160, 100, 300}, {80, 310, 140, 350}, {1100, 700, 1200, 800}});
    const auto& regions = coverage.regions();
    EXPECT_EQ(regions.size(), 2u) << "two of them touch";
    for (const PostRange& region : regions)
        for (const std::uint32_t post : {region.i0, region.j0}) EXPECT_EQ(post % 256, 0u);
    for_existing(plan, coverage, [&](const ChunkKey& key) {
        if (key.level >= 3) return;
        const PostRange posts = plan.lattice.posts_of(key);
        bool held = false;
        for (const PostRange& region : regions)
            held = held || (posts.i0 >= region.i0 && posts.j0 >= region.j0 && posts.i1 <= region.i1 && posts.j1 <= region.j1);
        EXPECT_TRUE(held);
    });
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_coverage
