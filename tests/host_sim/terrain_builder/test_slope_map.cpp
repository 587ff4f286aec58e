#include "host_sim/terrain_builder/slope_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_slope_map {
namespace {

using terrain::PostRange;
using test_support::BuildGround;

TEST(SlopeMap, IsAtLeastTheSteepestOfEveryCell) {
    const BuildGround ground(test_support::make_rough_raster(150, 100));
    const double north_m = base::radians(1.0 / 1200) * 6378000;
    double steepest = 0;
    for (std::uint32_t j = 0; j + 1 < 100; ++j)
        for (std::uint32_t i = 0; i + 1 < 150; ++i) {
            const double east_m = north_m * std::cos(ground.plan.lattice.latitude_rad(j));
            const auto h = [&](std::uint32_t a, std::uint32_t b) { return ground.raster.height_m[ground.raster.at(a, b)]; };
            const double slope =
                std::max(std::hypot((h(i + 1, j) - h(i, j)) / east_m, (h(i, j + 1) - h(i, j)) / north_m),
                         std::hypot((h(i + 1, j + 1) - h(i, j + 1)) / east_m, (h(i + 1, j + 1) - h(i + 1, j)) / north_m));
            EXPECT_GE(ground.slopes.steepest({i, j, i + 1, j + 1}, 0), slope);
            steepest = std::max(steepest, slope);
        }
    EXPECT_LT(ground.slopes.steepest({0, 0, 149, 99}, 0), 1.6 * steepest) << "far from what there is";
}

TEST(SlopeMap, LooksAroundAsFarAsItIsAsked) {
    const BuildGround ground(
        test_support::make_raster(200, 200, [](auto i, auto j) { return i == 100 && j == 100 ? 500.0f : 0.0f; }));
    const PostRange far{0, 96, 32, 128};
    EXPECT_LT(ground.slopes.steepest(far, 0), 0.01);
    EXPECT_LT(ground.slopes.steepest(far, 32), 0.01);
    EXPECT_GT(ground.slopes.steepest(far, 65), 4);
    EXPECT_EQ(ground.slopes.steepest(far, 1000000), ground.slopes.steepest({0, 0, 199, 199}, 0));
}

TEST(SlopeMap, MeasuresEachRowByItsOwnWidth) {
    // Round the pole columns are close together in the first rows only, where the ground is even.
    const BuildGround ground(test_support::make_raster(
        360, 40, [](auto i, auto j) { return i % 2 != 0 && j > 20 ? 4000.0f : 0.0f; }, -180, 89.5, 1));
    ASSERT_TRUE(ground.plan.has_north_pole());
    const double narrow_m = base::radians(1.0) * 6378000 * std::cos(base::radians(89.5)),
                 steep_m = base::radians(1.0) * 6378000 * std::cos(base::radians(90 - 20.5));
    EXPECT_LT(ground.slopes.steepest({0, 0, 32, 32}, 0), 1.05 * std::hypot(4000 / steep_m, 4000 / 111000.0));
    EXPECT_GT(4000 / narrow_m, 0.4) << "control: over the narrowest cells it would be this steep";
}

TEST(SlopeMap, LooksOverTheSeam) {
    const BuildGround ground(test_support::make_raster(
        144, 40, [](auto i, auto) { return i == 140 ? 9000.0f : 0.0f; }, -178.75, 45, 2.5));
    EXPECT_TRUE(ground.plan.lattice.is_closed());
    EXPECT_LT(ground.slopes.steepest({0, 0, 32, 32}, 0), 0.01);
    EXPECT_GT(ground.slopes.steepest({0, 0, 32, 32}, 32), 0.02);
}

TEST(SlopeMap, VoidsHaveNoSlopeAndTheFileIsReadAgain) {
    Raster raster = test_support::make_raster(70, 70, [](auto i, auto) { return i == 20 ? 800.0f : 0.0f; });
    for (std::uint32_t j = 0; j < 70; ++j) raster.post_class[raster.at(20, j)] = terrain::PostClass::void_;
    const BuildGround ground(raster);
    EXPECT_LT(ground.slopes.steepest({0, 0, 69, 69}, 0), 0.01);
    const BuildGround rough(test_support::make_rough_raster(70, 70));
    const SlopeMap again(rough.plan, rough.folder.file("slopes"));
    EXPECT_EQ(again.steepest({0, 0, 69, 69}, 0), rough.slopes.steepest({0, 0, 69, 69}, 0));
}

}  // namespace
}  // namespace tedavis::host_sim::test_slope_map
