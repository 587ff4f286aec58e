#include "host_sim/terrain_builder/attributes/height_planes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/terrain/attribute_terrain.hpp"

namespace tedavis::host_sim::test_height_planes {
namespace {

using terrain::PostClass;
using test_support::make_tile;
using test_support::post_of;

double slanted(int i, int j) { return 100 + 3 * i - 5 * j; }

TEST(HeightPlanes, PostsAndHalfPostsHoldTheHeights) {
    const AttributeTile tile = make_tile(7, 5, 20, 30, slanted);
    const HeightPlanes planes(tile);
    EXPECT_EQ(planes.stride % kLanes, 0u);
    for (const auto& [column, row] : {std::pair(0, 0), std::pair(6, 4), std::pair(-32, -32), std::pair(37, 35)}) {
        const std::size_t at = planes.at(column, row);
        const auto height_m = static_cast<float>(slanted(column, row));
        EXPECT_EQ(planes.high[at_post][at], height_m);
        EXPECT_EQ(planes.low[at_post][at], height_m);
        EXPECT_EQ(planes.high[half_south][at], height_m - 2.5f);
        EXPECT_EQ(planes.low[half_east][at], height_m + 1.5f);
    }
}

TEST(HeightPlanes, PostsWithoutHeightNeitherRaiseNorLower) {
    AttributeTile tile = make_tile(4, 4, 20, 30, slanted);
    tile.post_class[post_of(tile, 1, 1)] = PostClass::void_;
    tile.post_class[post_of(tile, 2, 1)] = PostClass::outside;
    tile.post_class[post_of(tile, 3, 3)] = PostClass::sea;
    tile.height_m[post_of(tile, 1, 1)] = std::numeric_limits<float>::quiet_NaN();
    const HeightPlanes planes(tile);
    const std::size_t void_post = planes.at(1, 1);
    EXPECT_EQ(planes.high[at_post][void_post], -kNoHeight_m);
    EXPECT_EQ(planes.low[at_post][void_post], kNoHeight_m);
    EXPECT_EQ(planes.validity[void_post], 0);
    EXPECT_EQ(planes.high[half_east][void_post], -kNoHeight_m) << "two posts without height";
    EXPECT_EQ(planes.low[half_east][void_post], kNoHeight_m);
    EXPECT_EQ(planes.high[half_east][planes.at(0, 1)], slanted(0, 1)) << "the post that has a height counts alone";
    EXPECT_EQ(planes.high[half_south][planes.at(1, 1)], slanted(1, 2));
    EXPECT_EQ(planes.low[half_south][planes.at(1, 0)], slanted(1, 0));
    EXPECT_EQ(planes.validity[planes.at(3, 3)], 1) << "sea has a height";
}

using HeightPlanesDeathTest = ::testing::Test;
TEST(HeightPlanesDeathTest, TilesWithoutTheirApronAreRefused) {
    AttributeTile tile = make_tile(4, 4, 20, 30, slanted);
    tile.height_m.pop_back();
    EXPECT_DEATH(HeightPlanes{tile}, "height_m");
    tile = make_tile(4, 4, 0, 30, slanted);
    EXPECT_DEATH(HeightPlanes{tile}, "east_m > 0");
}

}  // namespace
}  // namespace tedavis::host_sim::test_height_planes
