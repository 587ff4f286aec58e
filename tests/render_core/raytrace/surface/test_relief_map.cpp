#include "render_core/raytrace/surface/relief_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_relief_map {
namespace {

using test_support::Dice;

struct MadeRelief {
    test_support::HeldHeights<std::int16_t> heights = test_support::dice_heights<std::int16_t>(5, 7, 1, 1000);
    ReliefMap map;
    MadeRelief() {
        map.tile = heights.grid();
        map.full_scale = 1000;
        map.amplitude = 3;
        map.density = 2.5;
    }
};

TEST(ReliefMap, RepeatsWithoutASeam) {
    const MadeRelief made;
    Dice dice(1);
    for (int n = 0; n < 2000; ++n) {
        const double x = dice.between(0, 8), y = dice.between(0, 8);
        const double here = relief_at(made.map, x, y).height;
        EXPECT_NEAR(here, relief_at(made.map, x + 4, y - 28).height, 1e-9) << "5 and 7 posts, 2.5 to a post: 2 and 2.8 across";
        EXPECT_NEAR(relief_at(made.map, 2 - 1e-9, y).height, relief_at(made.map, 2 + 1e-9, y).height, 1e-6);
        EXPECT_NEAR(relief_at(made.map, 1e-9, y).height, relief_at(made.map, -1e-9, y).height, 1e-6);
    }
}

TEST(ReliefMap, GoesThroughItsPosts) {
    const MadeRelief made;
    for (std::uint32_t row = 0; row < 7; ++row)
        for (std::uint32_t column = 0; column < 5; ++column)
            EXPECT_NEAR(relief_at(made.map, column / 2.5, row / 2.5).height, 3 * made.heights.grid().at(column, row) / 1000.0,
                        1e-9);
}

TEST(ReliefMap, KeepsWithinItsBounds) {
    MadeRelief made;
    made.map.full_scale = 300;
    Dice dice(2);
    for (int n = 0; n < 50000; ++n) {
        const double x = dice.between(-100, 100), y = dice.between(-100, 100);
        const SurfacePoint point = relief_at(made.map, x, y);
        ASSERT_LE(std::abs(point.height), 3);
        ASSERT_LE(std::abs(point.slope_x), steepest_slope(made.map));
        ASSERT_LE(std::abs(point.slope_y), steepest_slope(made.map));
        constexpr double kStep = 1e-7;
        const double crease = std::abs(x * 2.5 - std::round(x * 2.5));
        if (crease < 1e-5) continue;
        ASSERT_NEAR(point.slope_x,
                    (relief_at(made.map, x + kStep, y).height - relief_at(made.map, x - kStep, y).height) / (2 * kStep), 1e-4);
    }
}

TEST(ReliefMap, WhatHasNoHeightAddsNone) {
    MadeRelief made;
    made.heights.fill([](std::uint32_t, std::uint32_t) { return HeightGrid<std::int16_t>::kVoid; });
    EXPECT_EQ(relief_at(made.map, 1.3, 2.7).height, 0);
}

}  // namespace
}  // namespace tedavis::raytrace::test_relief_map
