#include "render_core/raytrace/surface/bicubic_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_bicubic_patch {
namespace {

using test_support::Dice;
using test_support::HeldHeights;

BicubicPatch patch_of(const HeightGrid<std::int16_t>& grid, std::uint32_t column, std::uint32_t row) {
    return bicubic_patch(patch_posts(grid, column, row));
}

/// Catmull and Rom's blending functions, in the other way to write the same surface.
struct Blend {
    long double w[4], slope[4];
    explicit Blend(long double t)
        : w{(-t + 2 * t * t - t * t * t) / 2, (2 - 5 * t * t + 3 * t * t * t) / 2, (t + 4 * t * t - 3 * t * t * t) / 2,
            (-t * t + t * t * t) / 2},
          slope{(-1 + 4 * t - 3 * t * t) / 2, (-10 * t + 9 * t * t) / 2, (1 + 8 * t - 9 * t * t) / 2, (-2 * t + 3 * t * t) / 2} {}
};

TEST(BicubicPatch, IsCatmullAndRomsInLongDouble) {
    const auto heights = test_support::dice_heights<std::int16_t>(12, 11, 5, 20000);
    Dice dice(1);
    for (int n = 0; n < 20000; ++n) {
        const PatchPosts posts = patch_posts(heights.grid(), dice.below(11), dice.below(10));
        const double u = dice.unit(), v = dice.unit();
        const Blend across(u), down(v);
        long double height = 0, slope_x = 0, slope_y = 0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                height += across.w[i] * down.w[j] * posts.z[j][i];
                slope_x += across.slope[i] * down.w[j] * posts.z[j][i];
                slope_y += across.w[i] * down.slope[j] * posts.z[j][i];
            }
        const SurfacePoint point = bicubic_patch(posts).at(u, v);
        ASSERT_NEAR(point.height, static_cast<double>(height), 1e-10);
        ASSERT_NEAR(point.slope_x, static_cast<double>(slope_x), 1e-9);
        ASSERT_NEAR(point.slope_y, static_cast<double>(slope_y), 1e-9);
    }
}

TEST(BicubicPatch, NeighboursShareTheirSidesBitForBit) {
    auto heights = test_support::dice_heights<float>(20, 20, 6, 3000);
    Dice dice(2);
    for (int n = 0; n < 40; ++n) heights.at(dice.below(20), dice.below(20)) = HeightGrid<float>::kVoid;
    int compared = 0;
    for (std::uint32_t row = 0; row < 18; ++row)
        for (std::uint32_t column = 0; column < 18; ++column)
            for (const bool is_right : {true, false}) {
                const PatchPosts here = patch_posts(heights.grid(), column, row);
                const PatchPosts there = patch_posts(heights.grid(), column + (is_right ? 1 : 0), row + (is_right ? 0 : 1));
                if (!here.has_surface || !there.has_surface) continue;
                const double t = dice.unit();
                const SurfacePoint a = bicubic_patch(here).at(is_right ? 1 : t, is_right ? t : 1);
                const SurfacePoint b = bicubic_patch(there).at(is_right ? 0 : t, is_right ? t : 0);
                ASSERT_EQ(a.height, b.height);
                ++compared;
            }
    EXPECT_GT(compared, 300);
}

TEST(BicubicPatch, TheSlopeHasNoJumpWhereNothingIsVoid) {
    const auto heights = test_support::dice_heights<std::int16_t>(10, 10, 7);
    Dice dice(3);
    for (std::uint32_t row = 0; row < 8; ++row)
        for (std::uint32_t column = 0; column < 8; ++column) {
            const double t = dice.unit();
            const SurfacePoint a = patch_of(heights.grid(), column, row).at(1, t),
                               b = patch_of(heights.grid(), column + 1, row).at(0, t);
            ASSERT_NEAR(a.slope_x, b.slope_x, 1e-9);
            const SurfacePoint c = patch_of(heights.grid(), column, row).at(t, 1),
                               d = patch_of(heights.grid(), column, row + 1).at(t, 0);
            ASSERT_NEAR(c.slope_y, d.slope_y, 1e-9);
        }
}

TEST(BicubicPatch, APlaneIsExactUpToTheBorder) {
    const auto heights = HeldHeights<std::int16_t>(5, 4).fill([](double x, double y) { return 12 * x - 5 * y; });
    for (std::uint32_t row = 0; row < 3; ++row)
        for (std::uint32_t column = 0; column < 4; ++column)
            for (const double u : {0.0, 0.3, 1.0})
                for (const double v : {0.0, 0.6, 1.0}) {
                    const SurfacePoint point = patch_of(heights.grid(), column, row).at(u, v);
                    EXPECT_NEAR(point.slope_x, 12, 1e-12);
                    EXPECT_NEAR(point.slope_y, -5, 1e-12);
                    EXPECT_NEAR(point.height, 12 * (column + u) - 5 * (row + v), 1e-12);
                }
}

TEST(BicubicPatch, TheHullHoldsEveryHeightBitForBit) {
    const auto heights = test_support::dice_heights<float>(30, 30, 9, 4000);
    Dice dice(4);
    int above_posts = 0;
    for (int n = 0; n < 60000; ++n) {
        const PatchPosts posts = patch_posts(heights.grid(), dice.below(29), dice.below(29));
        const BicubicPatch patch = bicubic_patch(posts);
        const double height = patch.at(dice.unit(), dice.unit()).height;
        const auto [low, high] = std::minmax_element(&patch.control[0][0], &patch.control[0][0] + 16);
        ASSERT_GE(height, *low / kControlScale);
        ASSERT_LE(height, *high / kControlScale);
        above_posts += height > std::max({posts.z[1][1], posts.z[1][2], posts.z[2][1], posts.z[2][2]}) ? 1 : 0;
    }
    EXPECT_GT(above_posts, 1000) << "the posts alone must fail as a bound";
}

TEST(BicubicPatch, GdalwarpResamplesLikeIt) {
    const test_support::TemporaryFolder folder;
    const std::string in = folder.path() + "/in.asc", out = folder.path() + "/out.asc";
    const auto heights = test_support::hilly_heights<std::int16_t>(12, 12, 4);
    {
        std::ofstream file(in);
        file << "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
        for (std::uint32_t row = 0; row < 12; ++row)
            for (std::uint32_t column = 0; column < 12; ++column) file << heights.grid().at(column, row) << ".0 ";
    }
    // Five samples a post, none on a post; only where all sixteen posts are there.
    const std::string command =
        "gdalwarp -q -ot Float64 -wt Float64 -r cubic -et 0 -te 3 3 9 9 -tr 0.2 0.2 -of AAIGrid -co DECIMAL_PRECISION=9 " + in +
        " " + out;
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(out);
    std::string word;
    double value = 0;
    int across = 0, down = 0;
    file >> word >> across >> word >> down >> word >> value >> word >> value >> word >> value;
    ASSERT_EQ(across, 30);
    double worst = 0;
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 30; ++column) {
            ASSERT_TRUE(static_cast<bool>(file >> value));
            const double x = 3 + (column + 0.5) * 0.2 - 0.5, y = 3 + (row + 0.5) * 0.2 - 0.5;
            const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
            worst = std::max(worst, std::abs(patch_of(heights.grid(), i, j).at(x - i, y - j).height - value));
        }
    EXPECT_LT(worst, 1e-3) << "of heights that range over hundreds";
}

}  // namespace
}  // namespace tedavis::raytrace::test_bicubic_patch
