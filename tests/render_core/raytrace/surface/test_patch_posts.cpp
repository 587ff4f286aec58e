#include "render_core/raytrace/surface/patch_posts.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_patch_posts {
namespace {

using test_support::HeldHeights;
constexpr std::int16_t kVoid = HeightGrid<std::int16_t>::kVoid;

HeldHeights<std::int16_t> a_plane() {
    return HeldHeights<std::int16_t>(6, 5).fill([](double x, double y) { return 100 + 7 * x - 4 * y; });
}

void expect_plane(const PatchPosts& posts, int column, int row) {
    ASSERT_TRUE(posts.has_surface);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(posts.z[j][i], 100 + 7 * (column + i - 1) - 4 * (row + j - 1))
                << column << ' ' << row << ' ' << i << ' ' << j;
}

TEST(PatchPosts, APlaneGoesOnBeyondTheBorder) {
    const auto heights = a_plane();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 5; ++column) expect_plane(patch_posts(heights.grid(), column, row), column, row);
}

TEST(PatchPosts, APlaneGoesOnPastEveryPatternOfVoidsRoundACell) {
    // The ring has 12 posts; every subset of them is void, in the middle of the grid and in its corner.
    const auto ring_of = [](int n) {
        return n < 4 ? std::pair(n, 0) : n < 8 ? std::pair(n - 4, 3) : std::pair(n % 2 * 3, n < 10 ? 1 : 2);
    };
    for (const auto& [column, row] : {std::pair(2, 1), std::pair(0, 0), std::pair(4, 3)})
        for (int pattern = 0; pattern < 1 << 12; ++pattern) {
            auto heights = a_plane();
            for (int n = 0; n < 12; ++n) {
                const int x = column + ring_of(n).first - 1, y = row + ring_of(n).second - 1;
                if ((pattern >> n & 1) != 0 && x >= 0 && y >= 0 && x < 6 && y < 5) heights.at(x, y) = kVoid;
            }
            expect_plane(patch_posts(heights.grid(), column, row), column, row);
            if (HasFailure()) return;
        }
}

TEST(PatchPosts, ACellWithoutAPostHasNoSurface) {
    for (int n = 0; n < 16; ++n) {
        auto heights = a_plane();
        for (int k = 0; k < 4; ++k)
            if ((n >> k & 1) != 0) heights.at(2 + k % 2, 1 + k / 2) = kVoid;
        EXPECT_EQ(patch_posts(heights.grid(), 2, 1).has_surface, n == 0);
    }
}

TEST(PatchPosts, PostsAreReadWhereTheyAre) {
    const auto heights = test_support::dice_heights<float>(9, 7, 3);
    const PatchPosts posts = patch_posts(heights.grid(), 4, 2);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) EXPECT_EQ(posts.z[j][i], heights.grid().at(3 + i, 1 + j));
}

}  // namespace
}  // namespace tedavis::raytrace::test_patch_posts
