#include "target/self_test/geodesy_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tedavis::target::test_geodesy_check {
namespace {

/// Names of the checks that do not hold.
std::string failures(const OwnGeodesy& own) {
    SelfTestReport report;
    check_geodesy(report, own);
    EXPECT_EQ(report.checks().size(), 3u);
    std::string names;
    for (const SelfCheck& check : report.checks())
        if (!check.holds) names += std::string(check.name.view()) + " ";
    return names;
}

TEST(GeodesyCheck, TheProgramsOwnGeodesyHolds) { EXPECT_EQ(failures({}), ""); }

/// Each spoilt as a real fault would: a sphere, a rounded constant, a sign, float in place of double, not a number.
TEST(GeodesyCheck, SpoiltConversionsAreFound) {
    OwnGeodesy own;
    own.to_ecef = [](const earth::Geodetic& place) noexcept {
        const double radius = earth::kMeanRadius_m + place.height.m, c = std::cos(place.latitude_rad);
        return earth::Ecef{radius * c * std::cos(place.longitude_rad), radius * c * std::sin(place.longitude_rad),
                           radius * std::sin(place.latitude_rad)};
    };
    EXPECT_EQ(failures(own), "geodetic_to_ecef ");
    own.to_ecef = [](const earth::Geodetic& place) noexcept {
        earth::Ecef ecef = earth::to_ecef(place);
        ecef.z *= 1 + 1e-12;
        return ecef;
    };
    EXPECT_EQ(failures(own), "geodetic_to_ecef ");
    own = {};
    own.from_ecef = [](const earth::Ecef& place) noexcept {
        earth::Geodetic geodetic = earth::from_ecef(place);
        geodetic.longitude_rad = static_cast<double>(static_cast<float>(geodetic.longitude_rad));
        return geodetic;
    };
    EXPECT_EQ(failures(own), "ecef_to_geodetic ");
    own.from_ecef = [](const earth::Ecef& place) noexcept {
        earth::Geodetic geodetic = earth::from_ecef(place);
        if (geodetic.latitude_rad > 1.5) geodetic.height.m = std::nan("");
        return geodetic;
    };
    EXPECT_EQ(failures(own), "ecef_to_geodetic ");
    own = {};
    own.surface_distance_m = [](const earth::Geodetic& a, const earth::Geodetic& b) noexcept {
        return earth::surface_distance_m(a, b) * (1 + 3e-6);
    };
    EXPECT_EQ(failures(own), "surface_distance ");
}

}  // namespace
}  // namespace tedavis::target::test_geodesy_check
