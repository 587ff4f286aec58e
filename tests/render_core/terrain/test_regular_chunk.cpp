#include "render_core/terrain/regular_chunk.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace tedavis::terrain::test_regular_chunk {
namespace {

TEST(RegularChunk, TheBorderComesFirstAndClockwise) {
    const RegularGrid grid{4, 3};
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> order = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2},
                                                                        {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}, {2, 1}};
    for (std::uint32_t n = 0; n < order.size(); ++n) EXPECT_EQ(grid.index_of(order[n].first, order[n].second), n);
    EXPECT_EQ(grid.border_count(), 10u);
    EXPECT_EQ(grid.triangle_count(), 12u);
}

TEST(RegularChunk, EveryPostHasItsOwnIndex) {
    for (const RegularGrid& grid : {RegularGrid{2, 2}, {2, 33}, {33, 2}, {33, 33}, {5, 9}}) {
        std::set<std::uint32_t> indices;
        for (std::uint32_t j = 0; j < grid.rows; ++j)
            for (std::uint32_t i = 0; i < grid.columns; ++i) {
                const bool border = i == 0 || j == 0 || i == grid.columns - 1 || j == grid.rows - 1;
                EXPECT_EQ(grid.index_of(i, j) < grid.border_count(), border);
                indices.insert(grid.index_of(i, j));
            }
        EXPECT_EQ(indices.size(), grid.vertex_count());
        EXPECT_EQ(*indices.rbegin(), grid.vertex_count() - 1);
    }
}

TEST(RegularChunk, ThePostsOfALevelEndWithTheChunk) {
    const RegularGrid whole = regular_grid(256, 100, 3);
    EXPECT_EQ(whole.columns, 33u);
    EXPECT_EQ(whole.rows, 14u);
    EXPECT_EQ(regular_post(12, 100, 3), 96u);
    EXPECT_EQ(regular_post(13, 100, 3), 100u) << "the last row is nearer";
    EXPECT_EQ(regular_post(32, 256, 3), 256u);
    EXPECT_EQ(regular_grid(1, 1, 5).columns, 2u);
    EXPECT_EQ(regular_post(1, 1, 5), 1u);
}

}  // namespace
}  // namespace tedavis::terrain::test_regular_chunk
