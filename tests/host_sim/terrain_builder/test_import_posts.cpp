#include "host_sim/terrain_builder/import_posts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::host_sim::test_import_posts {
namespace {

using terrain::PostClass;
using test_support::BuildGround;
using test_support::make_raster;

TEST(PostImport, TakesEveryPostOnce) {
    const Raster raster = make_raster(150, 90, [](auto i, auto j) { return i == 70 && j == 3 ? std::nanf("") : 3.0f * i + j; });
    const BuildGround ground(raster);
    const LatticeWindow all = ground.all();
    for (std::uint32_t j = 0; j < 90; ++j)
        for (std::uint32_t i = 0; i < 150; ++i) {
            ASSERT_EQ(all.post_class[all.at(i, j)], raster.post_class[raster.at(i, j)]);
            ASSERT_EQ(all.height_m[all.at(i, j)], i == 70 && j == 3 ? 0 : raster.height_m[raster.at(i, j)]);
        }
    EXPECT_EQ(ground.statistics.void_posts, 1u);
    EXPECT_EQ(ground.statistics.valid_posts, 150u * 90 - 1);
    EXPECT_EQ(ground.statistics.min_height_m, 0);
    EXPECT_EQ(ground.statistics.max_height_m, 3 * 149 + 89);
}

TEST(PostImport, BlocksCoverTheSource) {
    for (const std::uint32_t columns : {5000u, 100u}) {
        const BuildPlan plan = make_build_plan(test_support::post_grid(0, 10, 0.001, columns, 700), {});
        const ImportBlocks blocks(plan);
        std::uint64_t posts = 0;
        std::set<std::pair<std::uint32_t, std::uint32_t>> corners;
        for (std::uint32_t n = 0; n < blocks.count(); ++n) {
            const ImportBlocks::Block b = blocks.at(n);
            EXPECT_TRUE(b.i + b.columns <= columns && b.j + b.rows <= 700 && corners.insert({b.j, b.i}).second);
            posts += std::uint64_t{b.columns} * b.rows;
        }
        EXPECT_EQ(posts, std::uint64_t{columns} * 700);
    }
}

TEST(PostImport, ClosesRoundTheEarthAndMakesPoles) {
    const BuildGround ground(test_support::make_earth_raster(5));
    const LatticeWindow all = ground.all();
    double north = 0, south = 0;
    for (std::uint32_t i = 0; i < 72; ++i) {
        north += ground.raster.height_m[ground.raster.at(i, 0)];
        south += ground.raster.height_m[ground.raster.at(i, 35)];
    }
    for (std::uint32_t i = 0; i <= 72; ++i) {
        ASSERT_EQ(all.height_m[all.at(i, 0)], static_cast<float>(north / 72));
        ASSERT_EQ(all.height_m[all.at(i, 37)], static_cast<float>(south / 72));
        ASSERT_EQ(all.surface_m[all.at(i, 0)], all.surface_m[all.at(0, 0)]);
    }
    for (std::uint32_t j = 0; j < 38; ++j) ASSERT_EQ(all.height_m[all.at(72, j)], all.height_m[all.at(0, j)]);
    EXPECT_EQ(all.height_m[all.at(9, 5)], ground.raster.height_m[ground.raster.at(9, 4)]) << "row 0 is the pole";
}

TEST(PostImport, APoleWithoutNeighboursIsVoid) {
    Raster raster = test_support::make_earth_raster(5);
    for (std::uint32_t i = 0; i < 72; ++i) raster.post_class[raster.at(i, 0)] = PostClass::void_;
    for (std::uint32_t i = 0; i < 72; ++i) raster.post_class[raster.at(i, 35)] = PostClass::sea;
    const BuildGround ground(raster);
    const LatticeWindow all = ground.all();
    EXPECT_EQ(all.post_class[all.at(4, 0)], PostClass::void_);
    EXPECT_EQ(all.post_class[all.at(4, 37)], PostClass::sea);
}

TEST(PostImport, ARowThatTheSourceHasAtThePoleBecomesOnePoint) {
    const Raster raster = make_raster(
        73, 37, [](auto i, auto j) { return j == 0 ? 10.0f * i : 5.0f; }, -180, 90, 5);
    const BuildGround ground(raster);
    const LatticeWindow all = ground.all();
    EXPECT_EQ(ground.plan.header.rows, 37u);
    for (std::uint32_t i = 0; i <= 72; ++i) ASSERT_EQ(all.height_m[all.at(i, 0)], 355) << "the mean of columns 0 to 71";
}

}  // namespace
}  // namespace tedavis::host_sim::test_import_posts
