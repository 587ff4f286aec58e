#include "render_core/earth/geodetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "render_core/base/units.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::earth::test_geodetic {
namespace {

using base::kPi;
using base::radians;

/// The same direction in the plane, whatever turn was counted.
void expect_same_direction(double a_rad, double b_rad, double tolerance) {
    EXPECT_NEAR(std::sin(a_rad), std::sin(b_rad), tolerance) << a_rad << " against " << b_rad;
    EXPECT_NEAR(std::cos(a_rad), std::cos(b_rad), tolerance) << a_rad << " against " << b_rad;
}

TEST(Geodetic, longitude_wraps_to_the_half_open_turn) {
    EXPECT_EQ(wrap_longitude(0.0), 0.0);
    EXPECT_EQ(wrap_longitude(kPi), -kPi);
    EXPECT_EQ(wrap_longitude(-kPi), -kPi);
    EXPECT_EQ(wrap_longitude(3 * kPi), -kPi);
    EXPECT_EQ(wrap_longitude(std::nextafter(kPi, 0.0)), std::nextafter(kPi, 0.0));
    EXPECT_NEAR(wrap_longitude(radians(181.0)), radians(-179.0), 1e-15);
    EXPECT_NEAR(wrap_longitude(radians(-541.0)), radians(179.0), 1e-14);
}

TEST(Geodetic, heading_wraps_and_never_reaches_a_full_turn) {
    EXPECT_EQ(wrap_heading(2 * kPi), 0.0);
    EXPECT_EQ(wrap_heading(-1e-20), 0.0);
    EXPECT_EQ(wrap_heading(-std::numeric_limits<double>::denorm_min()), 0.0);
    EXPECT_FALSE(std::signbit(wrap_heading(-0.0)));
    EXPECT_NEAR(wrap_heading(radians(-90.0)), radians(270.0), 1e-15);
    EXPECT_NEAR(wrap_heading(radians(725.0)), radians(5.0), 1e-14);
}

TEST(Geodetic, wrapping_keeps_the_direction_and_the_range_for_any_angle) {
    std::mt19937_64 random(20240711);
    std::uniform_real_distribution<double> angle(-40.0, 40.0);
    for (int i = 0; i < 200000; ++i) {
        const double a = angle(random);
        const double longitude = wrap_longitude(a);
        const double heading = wrap_heading(a);
        ASSERT_GE(longitude, -kPi);
        ASSERT_LT(longitude, kPi);
        ASSERT_GE(heading, 0.0);
        ASSERT_LT(heading, 2 * kPi);
        expect_same_direction(longitude, a, 1e-14);
        expect_same_direction(heading, a, 1e-14);
        ASSERT_EQ(wrap_longitude(longitude), longitude) << "wrapping twice changes nothing";
        ASSERT_EQ(wrap_heading(heading), heading);
    }
}

TEST(Geodetic, extreme_finite_angles_stay_in_range) {
    for (double a : {1e300, -1e300, 1e16, -1e16, std::numeric_limits<double>::max()}) {
        EXPECT_LE(std::abs(wrap_longitude(a)), kPi);
        EXPECT_GE(wrap_heading(a), 0.0);
        EXPECT_LT(wrap_heading(a), 2 * kPi);
    }
}

TEST(Geodetic, difference_takes_the_shorter_way) {
    EXPECT_NEAR(angle_difference(radians(-179.0), radians(179.0)), radians(2.0), 1e-15);
    EXPECT_NEAR(angle_difference(radians(1.0), radians(359.0)), radians(2.0), 1e-14);
    EXPECT_NEAR(angle_difference(radians(350.0), radians(20.0)), radians(-30.0), 1e-14);
    EXPECT_EQ(angle_difference(1.25, 1.25), 0.0);
    EXPECT_NEAR(std::abs(angle_difference(kPi, 0.0)), kPi, 0.0);
}

TEST(Geodetic, difference_is_antisymmetric_and_at_most_half_a_turn) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> angle(-10.0, 10.0);
    for (int i = 0; i < 100000; ++i) {
        const double a = angle(random), b = angle(random);
        const double difference = angle_difference(a, b);
        ASSERT_LE(std::abs(difference), kPi);
        ASSERT_EQ(difference, -angle_difference(b, a));
        expect_same_direction(b + difference, a, 1e-14);
    }
}

/// The angle between the middle of two longitudes by a difference of theirs and the middle by vectors.
template <class Difference>
double middle_off_rad(double a, double b, const Difference& difference) {
    const double middle = b + 0.5 * difference(a, b);
    const double x = std::cos(a) + std::cos(b), y = std::sin(a) + std::sin(b);
    return std::abs(std::atan2(std::sin(middle) * x - std::cos(middle) * y, std::cos(middle) * x + std::sin(middle) * y));
}

/// The naive forms: numbers subtracted, and a remainder in floats.
double difference_of_numbers(double a, double b) { return a - b; }
float heading_by_remainder(float deg) { return deg < 0 ? std::fmod(deg, 360.F) + 360.F : std::fmod(deg, 360.F); }

TEST(Geodetic, differences_of_numbers_go_the_wrong_way_round) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> longitude(-kPi, kPi), apart(-2, 2);
    double ours = 0, naive = 0;
    for (int n = 0; n < 100'000; ++n) {
        const double a = longitude(random), b = wrap_longitude(a + apart(random));
        const double off = middle_off_rad(a, b, angle_difference);
        if (!(off <= ours)) ours = off;  // a NaN, too
        naive = std::max(naive, middle_off_rad(a, b, difference_of_numbers));
    }
    EXPECT_LT(ours, 1e-14);
    EXPECT_GT(naive, 3) << "control: the other side of the Earth";
    EXPECT_NEAR(middle_off_rad(radians(179.9), radians(-179.9), difference_of_numbers), kPi, 1e-12);
    EXPECT_EQ(heading_by_remainder(-1e-8F), 360.F) << "control: out of range";
    test_support::record_worst("A03", ours);
    test_support::record_control("A03", naive);
}

TEST(Geodetic, datums_convert_by_the_undulation_only) {
    // Everest: geoid 28.7 m below the ellipsoid.
    EXPECT_DOUBLE_EQ(to_ellipsoid(MslHeight{8848.0}, GeoidUndulation{-28.7}).m, 8819.3);
    EXPECT_DOUBLE_EQ(to_msl(to_ellipsoid(MslHeight{-430.0}, GeoidUndulation{19.1}), GeoidUndulation{19.1}).m, -430.0);
    static_assert(!std::is_convertible_v<MslHeight, EllipsoidHeight> && !std::is_convertible_v<EllipsoidHeight, MslHeight>);
}

}  // namespace
}  // namespace tedavis::earth::test_geodetic
