#include "host_sim/terrain_builder/ground.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_ground {
namespace {

TEST(LineGrid, NamesLinesAndTheirLevels) {
    const LineGrid grid{151, 3};
    EXPECT_EQ(grid.count(), 6u) << "0, 32, 64, 96, 128 and the last post";
    EXPECT_EQ(grid.post_of(5), 150u);
    EXPECT_EQ(grid.line_at(150), 5u);
    EXPECT_EQ(grid.line_at(96), 3u);
    EXPECT_TRUE(grid.is_line(64) && grid.is_line(150) && !grid.is_line(65));
    EXPECT_EQ(grid.top_level(0), 3u);
    EXPECT_EQ(grid.top_level(150), 3u);
    EXPECT_EQ(grid.top_level(32), 0u);
    EXPECT_EQ(grid.top_level(64), 1u);
    EXPECT_EQ(grid.top_level(96), 0u);
    EXPECT_EQ(grid.top_level(128), 2u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ground
