#include "host_sim/terrain_builder/attributes/local_relief.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/terrain/attribute_terrain.hpp"

namespace tedavis::host_sim::test_local_relief {
namespace {

using terrain::PostClass;
using test_support::make_tile;
using test_support::post_of;

double rough(int i, int j) { return 700 + 90 * std::sin(0.3 * i + 1) + 55 * std::cos(0.7 * j - 0.2 * i); }

// Oracle: the definition, post by post, in long double.
TEST(LocalRelief, IsHeightMinusTheMeanOfValidPosts) {
    AttributeTile tile = make_tile(21, 13, 20, 30, rough);
    for (int n = 0; n < 400; ++n) tile.post_class[static_cast<std::size_t>(n * n * 7 % 6000)] = PostClass::void_;
    const std::vector<float> relief = local_relief_m(tile);
    ASSERT_EQ(relief.size(), 21u * 13u);
    for (int row = 0; row < tile.rows; ++row) {
        for (int column = 0; column < tile.columns; ++column) {
            long double sum = 0, count = 0;
            for (int j = row - kReliefReach; j <= row + kReliefReach; ++j)
                for (int i = column - kReliefReach; i <= column + kReliefReach; ++i)
                    if (tile.post_class[post_of(tile, i, j)] == PostClass::land) {
                        sum += tile.height_m[post_of(tile, i, j)];
                        count += 1;
                    }
            const bool known = tile.post_class[post_of(tile, column, row)] == PostClass::land;
            const long double expected = known ? tile.height_m[post_of(tile, column, row)] - sum / count : 0;
            ASSERT_NEAR(relief[static_cast<std::size_t>(row * tile.columns + column)], static_cast<double>(expected), 0.001);
        }
    }
}

TEST(LocalRelief, PlanesHaveNoneAndAPeakHasItsOwn) {
    AttributeTile tile = make_tile(5, 5, 20, 30, [](int i, int j) { return 1000.1 + 2 * i - 3 * j; });
    for (const float relief_m : local_relief_m(tile)) EXPECT_NEAR(relief_m, 0, 0.001);
    tile = make_tile(5, 5, 20, 30, [](int, int) { return 1000.1; });
    for (const float relief_m : local_relief_m(tile)) EXPECT_EQ(relief_m, 0);
    tile.height_m[post_of(tile, 2, 2)] += 289;
    EXPECT_NEAR(local_relief_m(tile)[12], 288, 0.001) << "it counts in its own mean";
    EXPECT_NEAR(local_relief_m(tile)[0], -1, 0.001);
}

}  // namespace
}  // namespace tedavis::host_sim::test_local_relief
