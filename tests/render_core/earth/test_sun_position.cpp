#include "render_core/earth/sun_position.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::earth::test_sun_position {
namespace {

using base::degrees;
using base::radians;

/// Seconds of the Unix epoch of a day count since 2000-01-01T12:00 UTC.
double utc_of(double days_since_j2000) { return 946728000.0 + 86400.0 * days_since_j2000; }

TEST(SunPosition, AgreesWithTheWorkedExampleOfMeeus) {
    // Example 25.a: 1992 October 13, 0h dynamical time.
    const SunPlace sun = sun_place(2448908.5);
    EXPECT_NEAR(degrees(sun.right_ascension_rad), 198.38083, 1e-4);
    EXPECT_NEAR(degrees(sun.declination_rad), -7.78507, 1e-4);
}

/// Reda, Andreas, "Solar position algorithm for solar radiation applications", NREL/TP-560-34302, table A5.1: 2003-10-17
/// 12:30:30 at UTC-7, topocentric elevation without refraction 39.872046, azimuth 194.340241 degrees. The centre of the Earth
/// sees the sun higher by its parallax, 0.0019 degrees.
TEST(SunPosition, AgreesWithTheExampleOfTheSolarPositionAlgorithm) {
    const double utc_s = 1066419030;
    const SunPosition sun = sun_position(utc_s, radians(39.742476), radians(-105.1786));
    EXPECT_NEAR(degrees(sun.elevation_rad), 39.872046 + 0.0019, 0.01);
    EXPECT_NEAR(degrees(sun.azimuth_rad), 194.340241, 0.015);
    EXPECT_GT(std::fabs(degrees(sun_position(utc_s + 60, radians(39.742476), radians(-105.1786)).azimuth_rad) - 194.340241), 0.1)
        << "control: a minute later";
}

TEST(SunPosition, SummerSolsticeStandsOverTheTropic) {
    double highest_deg = -90;
    for (double hour = 0; hour < 24; hour += 0.05)
        highest_deg = std::max(highest_deg, degrees(sun_position(utc_of(8936.5 + hour / 24), radians(47.0), 0).elevation_rad));
    EXPECT_NEAR(highest_deg, 90 - 47 + 23.436, 0.01);  // 2024 June 20; obliquity of date
}

TEST(SunPosition, CulminatesInTheSouthAndIsMirroredAboutNoon) {
    const double latitude = radians(47.0), longitude = radians(10.0);
    double noon_s = 0, highest = -2;
    for (double s = 0; s < 86400; s += 10) {
        const SunPosition sun = sun_position(utc_of(8840.5) + s, latitude, longitude);
        if (sun.elevation_rad > highest) {
            highest = sun.elevation_rad;
            noon_s = s;
        }
    }
    EXPECT_NEAR(degrees(sun_position(utc_of(8840.5) + noon_s, latitude, longitude).azimuth_rad), 180, 0.2);
    const SunPosition before = sun_position(utc_of(8840.5) + noon_s - 7200, latitude, longitude);
    const SunPosition after = sun_position(utc_of(8840.5) + noon_s + 7200, latitude, longitude);
    EXPECT_LT(degrees(before.azimuth_rad), 180);
    EXPECT_NEAR(degrees(before.azimuth_rad), 360 - degrees(after.azimuth_rad), 0.3);
    EXPECT_NEAR(degrees(before.elevation_rad), degrees(after.elevation_rad), 0.2);
}

TEST(SunPosition, EastwardsTheSameSkyComesEarlier) {
    // 15 degrees are an hour of rotation, in which the sun itself moves by a twenty-fourth of a degree.
    const SunPosition here = sun_position(utc_of(9000) + 3600, radians(30.0), radians(20.0));
    const SunPosition east = sun_position(utc_of(9000), radians(30.0), radians(35.0));
    EXPECT_NEAR(degrees(here.elevation_rad), degrees(east.elevation_rad), 0.05);
    EXPECT_NEAR(degrees(here.azimuth_rad), degrees(east.azimuth_rad), 0.1);
}

TEST(SunPosition, ThePolesSeeTheDeclination) {
    const double utc_s = utc_of(8936.5);
    const double declination_deg = degrees(sun_place(2451545.0 + 8936.5 + 69.2 / 86400).declination_rad);
    EXPECT_NEAR(degrees(sun_position(utc_s, radians(90.0), 1).elevation_rad), declination_deg, 1e-9);
    EXPECT_NEAR(degrees(sun_position(utc_s, radians(-90.0), 2).elevation_rad), -declination_deg, 1e-9);
}

}  // namespace
}  // namespace tedavis::earth::test_sun_position
