#include "host_sim/terrain_builder/inset_posts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/terrain/lattice_windows.hpp"

namespace tedavis::host_sim::test_inset_posts {
namespace {

using namespace terrain;
using test_support::BuildGround;
using test_support::window_of;

TEST(InterpolatePosts, IsLinearOnTheTrianglesOfTheCoarsePosts) {
    const BuildGround ground(test_support::make_rough_raster(40, 30));
    LatticeWindow fine = window_of(-5, -3, 330, 250);
    interpolate_posts(ground.posts, 3, fine);
    const auto coarse = [&](std::uint32_t i, std::uint32_t j) { return double{ground.raster.height_m[ground.raster.at(i, j)]}; };
    for (std::int64_t j = -3; j < 247; ++j)
        for (std::int64_t i = -5; i < 325; ++i) {
            const std::size_t n = fine.at(i, j);
            if (i < 0 || j < 0 || i > 39 * 8 || j > 29 * 8) {
                ASSERT_EQ(fine.post_class[n], PostClass::outside) << i << " " << j;
                continue;
            }
            const auto a = static_cast<std::uint32_t>(std::min<std::int64_t>(i / 8, 38)),
                       b = static_cast<std::uint32_t>(std::min<std::int64_t>(j / 8, 28));
            const double u = static_cast<double>(i) / 8 - a, v = static_cast<double>(j) / 8 - b;
            const double nw = coarse(a, b), ne = coarse(a + 1, b), sw = coarse(a, b + 1), se = coarse(a + 1, b + 1);
            const double expected =
                u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
            ASSERT_NEAR(fine.height_m[n], expected, 2e-4) << i << " " << j;
            const bool is_coarse = i % 8 == 0 && j % 8 == 0;
            ASSERT_TRUE(!is_coarse || fine.height_m[n] == static_cast<float>(expected)) << "the coarse post itself";
        }
}

TEST(InterpolatePosts, WhatStandsOnAVoidIsVoid) {
    Raster raster = test_support::make_rough_raster(20, 20);
    raster.post_class[raster.at(7, 9)] = PostClass::void_;
    raster.post_class[raster.at(12, 3)] = PostClass::sea;
    const BuildGround ground(raster);
    LatticeWindow fine = window_of(0, 0, 77, 77);
    interpolate_posts(ground.posts, 2, fine);
    EXPECT_EQ(fine.post_class[fine.at(28, 36)], PostClass::void_);
    EXPECT_EQ(fine.post_class[fine.at(29, 36)], PostClass::void_) << "on its way to the next post";
    EXPECT_EQ(fine.post_class[fine.at(32, 36)], PostClass::land) << "the next post";
    EXPECT_EQ(fine.post_class[fine.at(32, 35)], PostClass::land) << "on a side that does not lead to it";
    EXPECT_EQ(fine.post_class[fine.at(48, 12)], PostClass::sea);
    EXPECT_EQ(fine.post_class[fine.at(49, 12)], PostClass::land);
}

TEST(InsetPosts, AreOwnWithinTheRegionAndInterpolatedOutside) {
    const BuildGround ground(test_support::make_rough_raster(80, 70));
    const test_support::TemporaryFolder folder;
    InsetPosts posts(ground.posts, 2, {128, 64, 255, 191}, folder.file("p"));
    LatticeWindow own = window_of(128, 64, 128, 128);
    own.height_m.assign(128 * 128, 7.5f);
    own.post_class.assign(128 * 128, PostClass::sea);
    posts.write(own);
    for (const auto& [i, j] : {std::pair{100, 50}, {140, 80}, {240, 180}, {0, 0}, {-4, 150}}) {
        LatticeWindow window = window_of(i, j, 40, 40), coarse = window;
        posts.read(window);
        interpolate_posts(ground.posts, 2, coarse);
        for (std::int64_t b = j; b < j + 40; ++b)
            for (std::int64_t a = i; a < i + 40; ++a) {
                const bool inside = a >= 128 && b >= 64 && a <= 255 && b <= 191;
                ASSERT_EQ(window.height_m[window.at(a, b)], inside ? 7.5f : coarse.height_m[coarse.at(a, b)]) << a << " " << b;
                ASSERT_EQ(window.post_class[window.at(a, b)], inside ? PostClass::sea : coarse.post_class[coarse.at(a, b)]);
            }
    }
}

TEST(RegionBlocks, AreTheChunksOfTheRegion) {
    const RegionBlocks blocks({256, 512, 768, 700}, 3);
    ASSERT_EQ(blocks.count(), 2u);
    EXPECT_EQ(blocks.chunk(0), (ChunkKey{3, 1, 2}));
    EXPECT_EQ(blocks.chunk(1), (ChunkKey{3, 2, 2}));
    const RegionBlocks many({0, 0, 1024, 768}, 3);
    std::set<std::uint64_t> seen;
    for (std::uint32_t n = 0; n < many.count(); ++n) seen.insert(many.chunk(n).packed());
    EXPECT_EQ(seen.size(), 12u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_posts
