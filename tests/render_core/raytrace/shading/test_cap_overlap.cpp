#include "render_core/raytrace/shading/cap_overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/raytrace/shading/arc_functions.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_cap_overlap {
namespace {

using test_support::Dice;

TEST(CapOverlap, IsWhatRandomPointsOfTheSmallerCapSay) {
    Dice dice(1);
    constexpr int kPoints = 20000;
    int beyond = 0;
    for (int n = 0; n < 150; ++n) {
        const double a = dice.between(0.01, kArcPi / 2), b = dice.between(0.004, a), d = dice.between(0, a + b);
        int within = 0;
        for (int k = 0; k < kPoints; ++k) {
            // Even over the cap round z, by its height.
            const double z = 1 - dice.unit() * (1 - std::cos(b)), turn = dice.between(0, 2 * kArcPi), r = std::sqrt(1 - z * z);
            const double along = r * std::cos(turn) * std::sin(d) + z * std::cos(d);
            within += along >= std::cos(a) ? 1 : 0;
        }
        const double share = within / double{kPoints}, exact = cap_overlap(a, b, d) / cap_area(b);
        const double sigma = std::sqrt(std::max(exact * (1 - exact), 1.0 / kPoints) / kPoints);
        beyond += std::abs(share - exact) > 3 * sigma ? 1 : 0;
        ASSERT_LT(std::abs(share - exact), 5 * sigma) << a << ' ' << b << ' ' << d;
    }
    EXPECT_LE(beyond, 3) << "of 150, three sigma: 0.4 are to be expected";
}

TEST(CapOverlap, ClosedFormInLongDouble) {
    Dice dice(2);
    for (int n = 0; n < 20000; ++n) {
        const double a = dice.between(0.05, 1.5), b = dice.between(0.05, 1.5),
                     d = std::abs(a - b) + dice.between(0.01, 0.99) * 2 * std::min(a, b);
        const long double ca = std::cos(static_cast<long double>(a)), cb = std::cos(static_cast<long double>(b)),
                          cd = std::cos(static_cast<long double>(d));
        const long double sa = std::sin(static_cast<long double>(a)), sb = std::sin(static_cast<long double>(b)),
                          sd = std::sin(static_cast<long double>(d));
        const long double area = 2 * (static_cast<long double>(kArcPi) - std::acos((cd - ca * cb) / (sa * sb)) -
                                      ca * std::acos((cb - ca * cd) / (sa * sd)) - cb * std::acos((ca - cb * cd) / (sb * sd)));
        ASSERT_NEAR(cap_overlap(a, b, d), static_cast<double>(area), 1e-9) << a << ' ' << b << ' ' << d;
    }
}

TEST(CapOverlap, BoundaryCasesAreLimitsAndNeverNan) {
    const double radii[] = {0, 1e-9, 0.00465, 0.3, 1, kArcPi / 2};
    for (const double a : radii)
        for (const double b : radii) {
            const double smaller = std::min(a, b);
            EXPECT_EQ(cap_overlap(a, b, a + b), 0);
            EXPECT_EQ(cap_overlap(a, b, std::abs(a - b)), cap_area(smaller));
            EXPECT_EQ(cap_overlap(a, b, 0), cap_area(smaller));
            EXPECT_EQ(cap_overlap(a, b, kArcPi), 0);
            for (const double d : {std::nextafter(a + b, 0.0), std::nextafter(std::abs(a - b), 4.0)})
                for (const double area : {cap_overlap(a, b, d), smooth_cap_overlap(a, b, d)}) {
                    EXPECT_GE(area, 0) << a << ' ' << b << ' ' << d;
                    EXPECT_LE(area, cap_area(smaller)) << a << ' ' << b << ' ' << d;
                }
        }
    EXPECT_DOUBLE_EQ(cap_area(kArcPi / 2), 2 * kArcPi);
}

TEST(CapOverlap, FallsWithTheDistance) {
    Dice dice(3);
    for (int n = 0; n < 300; ++n) {
        const double a = dice.between(0.004, 1.57), b = dice.between(0.004, 1.57);
        double exact = 1e30, smooth = 1e30;
        for (double d = 0; d < a + b + 0.01; d += (a + b) / 200) {
            ASSERT_LE(cap_overlap(a, b, d), exact + 1e-12);
            ASSERT_LE(smooth_cap_overlap(a, b, d), smooth);
            exact = cap_overlap(a, b, d);
            smooth = smooth_cap_overlap(a, b, d);
        }
    }
}

/// Of the smoothstep, in parts of the smaller cap, over distances and larger caps from so many times its size on.
double worst_of_smooth(double radius, double times) {
    double worst = 0;
    for (double a = times * radius; a < kArcPi / 2; a += 0.02)
        for (double d = a - radius; d < a + radius; d += radius / 50)
            worst = std::max(worst, std::abs(smooth_cap_overlap(a, radius, d) - cap_overlap(a, radius, d)) / cap_area(radius));
    return worst;
}

TEST(CapOverlap, TheSmoothOneKeepsWithinItsError) {
    for (const double radius : {0.00465, 0.05, 0.3}) EXPECT_LT(worst_of_smooth(radius, 1), 0.165) << radius;
    EXPECT_LT(worst_of_smooth(0.00465, 20), 0.05) << "the sun through an aperture of more than five degrees";
    EXPECT_GT(worst_of_smooth(0.00465, 20), 0.005) << "it is an approximation";
}

}  // namespace
}  // namespace tedavis::raytrace::test_cap_overlap
