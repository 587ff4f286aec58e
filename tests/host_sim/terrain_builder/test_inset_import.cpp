#include "host_sim/terrain_builder/inset_import.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_inset_import {
namespace {

using namespace terrain;
using test_support::BuildGround;
using test_support::make_raster;

constexpr double kStep = 1.0 / 400;

/// 100 x 80 coarse posts at 500 m, four fine posts to one, and the region round an inset.
struct Imported {
    BuildGround ground{make_raster(
        100, 80, [](auto, auto) { return 500.0f; }, 9.6, 47.1, kStep)};
    BuildPlan fine = make_finer_plan(ground.plan, 2);
    test_support::TemporaryFolder folder;
    InsetPosts posts{ground.posts, 2, {0, 0, 396, 316}, folder.file("p")};
    std::vector<Raster> rasters;
    std::vector<std::unique_ptr<InsetSampler>> samplers;

    explicit Imported(std::vector<Raster> insets) : rasters(std::move(insets)) {
        for (const Raster& raster : rasters)
            samplers.push_back(std::make_unique<InsetSampler>(fine, test_support::posts_of(raster)));
    }
    [[nodiscard]] InsetImport import() { return InsetImport(samplers, posts, ground.posts, 2); }
    LatticeWindow all() {
        LatticeWindow window;
        window.columns = 397;
        window.rows = 317;
        posts.read(window);
        return window;
    }
};

/// Fine posts 80..240 across and 60..200 down.
Raster inset(float height, double step = kStep / 4) {
    const auto columns = static_cast<std::uint32_t>(std::lround(160 * kStep / 4 / step)) + 1,
               rows = static_cast<std::uint32_t>(std::lround(140 * kStep / 4 / step)) + 1;
    return make_raster(
        columns, rows, [height](auto, auto) { return height; }, 9.6 + 20 * kStep, 47.1 - 15 * kStep, step);
}

TEST(InsetImport, BlendsFromTheRimInwards) {
    Imported imported({inset(600)});
    (void)imported.import().import({0, 0, 396, 316});
    const LatticeWindow all = imported.all();
    EXPECT_EQ(all.height_m[all.at(79, 130)], 500);
    EXPECT_EQ(all.height_m[all.at(80, 130)], 500) << "at the rim";
    EXPECT_EQ(all.height_m[all.at(80 + 32, 130)], 600) << "as far inside as the blend reaches";
    EXPECT_EQ(all.height_m[all.at(80 + 16, 130)], 550);
    for (std::int64_t i = 70; i < 250; ++i) {
        const float step = all.height_m[all.at(i + 1, 130)] - all.height_m[all.at(i, 130)];
        EXPECT_LE(std::abs(step), 100.0f / 32 + 1e-3f) << "no step, " << i;
        EXPECT_TRUE(i > 160 ? step <= 0 : step >= 0);
    }
    EXPECT_EQ(all.height_m[all.at(80, 60)], 500) << "at a corner";
}

TEST(InsetImport, VoidsOfAnInsetHaveARimToo) {
    Raster raster = inset(600);
    for (std::uint32_t j = 60; j < 80; ++j)
        for (std::uint32_t i = 70; i < 90; ++i) raster.post_class[raster.at(i, j)] = PostClass::void_;
    Imported imported({raster});
    (void)imported.import().import({0, 0, 396, 316});
    const LatticeWindow all = imported.all();
    EXPECT_EQ(all.height_m[all.at(160, 130)], 500) << "in the hole";
    EXPECT_EQ(all.post_class[all.at(160, 130)], PostClass::land);
    for (std::int64_t i = 100; i < 220; ++i)
        EXPECT_LE(std::abs(all.height_m[all.at(i + 1, 130)] - all.height_m[all.at(i, 130)]), 100.0f / 32 + 1e-3f) << i;
}

TEST(InsetImport, ReplacesVoidsBelow) {
    Imported imported({inset(600)});
    for (std::uint32_t j = 0; j < 80; ++j)
        for (std::uint32_t i = 0; i < 100; ++i) {
            const float none = 0;
            const PostClass post_class = PostClass::void_;
            imported.ground.posts.write(i, j, 1, 1, {&none, 1}, {&post_class, 1});
        }
    (void)imported.import().import({0, 0, 396, 316});
    const LatticeWindow all = imported.all();
    EXPECT_EQ(all.height_m[all.at(82, 130)], 600) << "nothing to blend with";
    EXPECT_EQ(all.post_class[all.at(70, 130)], PostClass::void_);
}

TEST(InsetImport, SamplesOtherStepsBilinearly) {
    const double step = kStep / 7;
    Raster raster = inset(0, step);
    for (std::uint32_t j = 0; j < raster.rows; ++j)
        for (std::uint32_t i = 0; i < raster.columns; ++i) raster.height_m[raster.at(i, j)] = 900 + 2.0f * i - 3.0f * j;
    Imported imported({raster});
    LatticeWindow window;
    window.i0 = 75;
    window.j0 = 55;
    window.columns = 60;
    window.rows = 50;
    imported.samplers[0]->read(window);
    for (std::int64_t j = 55; j < 105; ++j)
        for (std::int64_t i = 75; i < 135; ++i) {
            const std::size_t n = window.at(i, j);
            if (i < 80 || j < 60) {
                ASSERT_EQ(window.post_class[n], PostClass::void_);
            } else {
                const double x = (i - 80) * 7.0 / 4, y = (j - 60) * 7.0 / 4;
                ASSERT_NEAR(window.height_m[n], 900 + 2 * x - 3 * y, 1e-3);
            }
        }
    const PostRange footprint = imported.samplers[0]->footprint();
    EXPECT_TRUE(footprint.i0 == 80 && footprint.j0 == 60 && footprint.i1 == 240 && footprint.j1 == 200);
}

TEST(InsetImport, LaterInsetsLieOverEarlierOnes) {
    Imported imported({inset(600), inset(800)});
    (void)imported.import().import({0, 0, 396, 316});
    const LatticeWindow all = imported.all();
    EXPECT_EQ(all.height_m[all.at(160, 130)], 800);
}

TEST(InsetImport, BlocksAreIndependentAndCoarsePostsFollow) {
    Imported whole({inset(600)}), parts({inset(600)});
    (void)whole.import().import({0, 0, 396, 316});
    InsetImport import = parts.import();
    for (const PostRange& block : {PostRange{256, 128, 396, 316},
                                   {0, 0, 128, 128},
                                   {128, 0, 256, 128},
                                   {256, 0, 396, 128},
                                   {0, 128, 128, 316},
                                   {128, 128, 256, 316}})
        (void)import.import(block);
    EXPECT_EQ(parts.all().height_m, whole.all().height_m);
    import.write_back({0, 0, 396, 316}, parts.ground.posts);
    const LatticeWindow fine = parts.all(), coarse = parts.ground.window(0, 0, 100, 80);
    for (std::uint32_t j = 0; j < 80; ++j)
        for (std::uint32_t i = 0; i < 100; ++i) ASSERT_EQ(coarse.height_m[coarse.at(i, j)], fine.height_m[fine.at(4 * i, 4 * j)]);
}

TEST(InsetImport, VoidsAreFilledFromTheCoarsePosts) {
    Imported imported({inset(600)});
    const float filled = 321;
    const PostClass post_class = PostClass::void_;
    for (std::uint32_t i = 5; i < 8; ++i) imported.ground.posts.write(i, 5, 1, 1, {&filled, 1}, {&post_class, 1});
    InsetImport import = imported.import();
    (void)import.import({0, 0, 396, 316});
    import.fill_voids({0, 0, 396, 316});
    const LatticeWindow all = imported.all();
    EXPECT_EQ(all.post_class[all.at(25, 20)], PostClass::void_);
    EXPECT_EQ(all.height_m[all.at(25, 20)], 321);
    EXPECT_EQ(all.height_m[all.at(160, 130)], 600);
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_import
