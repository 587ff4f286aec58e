#include "render_core/raytrace/shading/arc_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_arc_functions {
namespace {

TEST(ArcFunctions, AreTheLibrarysInLongDouble) {
    test_support::Dice dice(1);
    for (int n = 0; n < 200000; ++n) {
        const double x = dice.between(-1, 1) * std::pow(10, dice.between(-8, 8)), y = dice.between(-1, 1),
                     angle = dice.between(-6.28, 6.28);
        ASSERT_NEAR(arc_tangent(x), static_cast<double>(std::atan(static_cast<long double>(x))), 1e-15) << x;
        ASSERT_NEAR(arc_cosine(y), static_cast<double>(std::acos(static_cast<long double>(y))),
                    1e-15 + 1e-16 / std::sqrt(1 - y * y))
            << y;
        ASSERT_NEAR(direction_of_angle(angle).x, static_cast<double>(std::cos(static_cast<long double>(angle))), 1e-15) << angle;
        ASSERT_NEAR(direction_of_angle(angle).y, static_cast<double>(std::sin(static_cast<long double>(angle))), 1e-15) << angle;
    }
}

TEST(ArcFunctions, Ends) {
    EXPECT_EQ(arc_tangent(0), 0);
    EXPECT_EQ(arc_tangent(std::numeric_limits<double>::infinity()), kArcPi / 2);
    EXPECT_EQ(arc_cosine(1), 0);
    EXPECT_EQ(arc_cosine(1.0000001), 0);
    EXPECT_EQ(arc_cosine(-1), kArcPi);
    EXPECT_EQ(arc_cosine(-1.5), kArcPi);
    for (int n = -4; n <= 4; ++n) {
        const glm::dvec2 turned = direction_of_angle(n * kArcPi / 2);
        EXPECT_EQ(std::abs(turned.x) + std::abs(turned.y), 1) << n;
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_arc_functions
