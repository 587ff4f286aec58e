#include "host_sim/scenario/local_plane.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_local_plane {
namespace {

/// GeographicLib's distance and azimuth from a place to another.
TEST(LocalPlane, IsThePlaneOfTheEllipsoidForTensOfKilometres) {
    const double latitude_deg = 36.6, longitude_deg = -84.2;
    const LocalPlane plane(base::radians(latitude_deg), base::radians(longitude_deg));
    for (const double bearing_deg : {0.0, 60.0, 135.0, 200.0, 300.0}) {
        const double away_m = 15'000, bearing = base::radians(bearing_deg);
        const PlanePlace at = plane.at(away_m * std::sin(bearing), away_m * std::cos(bearing));
        double distance_m = 0, azimuth_deg = 0, back_deg = 0;
        GeographicLib::Geodesic::WGS84().Inverse(latitude_deg, longitude_deg, base::degrees(at.latitude_rad),
                                                 base::degrees(at.longitude_rad), distance_m, azimuth_deg, back_deg);
        EXPECT_NEAR(distance_m, away_m, 0.002 * away_m) << bearing_deg;
        EXPECT_NEAR(std::remainder(azimuth_deg - bearing_deg, 360), 0, 0.15) << bearing_deg;
    }
}

TEST(LocalPlane, GoesOnAcrossTheAntimeridian) {
    const LocalPlane plane(0, base::radians(179.99));
    const PlanePlace at = plane.at(2'000, 0);
    EXPECT_NEAR(base::degrees(at.longitude_rad), -180 + 2'000 / 111'319.49 - 0.01, 1e-6);
}

}  // namespace
}  // namespace tedavis::host_sim::test_local_plane
