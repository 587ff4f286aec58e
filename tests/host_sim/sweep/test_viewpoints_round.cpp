#include "host_sim/sweep/viewpoints_round.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <set>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim::test_viewpoints_round {
namespace {

/// One that changes from place to place.
earth::GeoidUndulation sloping(double latitude_rad, double longitude_rad) {
    return {30 + 200 * (latitude_rad - 0.82) - 300 * (longitude_rad - 0.17)};
}

earth::Geodetic place_at(double latitude_deg, double longitude_deg, double msl_m) {
    const double latitude_rad = base::radians(latitude_deg), longitude_rad = base::radians(longitude_deg);
    return {latitude_rad, longitude_rad, earth::to_ellipsoid({msl_m}, sloping(latitude_rad, longitude_rad))};
}

TEST(ViewpointsRound, LieAsFarAndWhereTheyShould) {
    SweepRings rings;
    rings.bearings = 5;
    rings.distances_m = {1000, 100'000};
    rings.heights_m = {-50, 2000};
    const auto viewpoints = viewpoints_round(place_at(47, 9.7, 800), sloping, rings);
    ASSERT_EQ(viewpoints.size(), 20u);
    std::set<std::string> names;
    for (std::size_t n = 0; n < viewpoints.size(); ++n) {
        const Viewpoint& one = viewpoints[n];
        EXPECT_EQ(one.bearing_deg, 72.0 * static_cast<double>(n % 5));
        EXPECT_EQ(one.distance_m, rings.distances_m[n / 5 % 2]);
        EXPECT_EQ(one.height_m, rings.heights_m[n / 10]);
        double distance_m = 0, azimuth_deg = 0, back_deg = 0;
        GeographicLib::Geodesic::WGS84().Inverse(47, 9.7, one.pose.latitude_deg, one.pose.longitude_deg, distance_m, azimuth_deg,
                                                 back_deg);
        EXPECT_NEAR(distance_m, one.distance_m, 1e-4 * one.distance_m);
        EXPECT_NEAR(std::remainder(azimuth_deg - one.bearing_deg, 360), 0, 1e-3);
        EXPECT_NEAR(std::remainder(back_deg + 180 - one.pose.heading_deg, 360), 0, 0.05);
        EXPECT_NEAR(one.pose.altitude_msl_m, 800 + one.height_m, 1e-6);
        names.insert(one.name);
    }
    EXPECT_EQ(names.size(), 20u);
    EXPECT_EQ(viewpoints[1].name, "h-50_d1000_b072");
}

// The nose points at the place: also across the antimeridian and beside a pole.
TEST(ViewpointsRound, LookAtThePlace) {
    for (const auto& [latitude_deg, longitude_deg] : {std::pair{47.0, 9.7}, std::pair{-30.0, 179.99}, std::pair{89.9, 20.0}}) {
        const earth::Geodetic place = place_at(latitude_deg, longitude_deg, 300);
        for (const Viewpoint& one : viewpoints_round(place, sloping, SweepRings())) {
            const earth::Ecef eye = earth::to_ecef(one.position);
            const glm::dmat3 axes = earth::body_axes(base::radians(one.pose.latitude_deg), base::radians(one.pose.longitude_deg),
                                                     base::radians(one.pose.heading_deg), base::radians(one.pose.pitch_deg), 0);
            EXPECT_NEAR(glm::dot(glm::normalize(earth::to_ecef(place) - eye), axes[0]), 1, 1e-12) << one.name;
            EXPECT_EQ(one.pose.roll_deg, 0);
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_viewpoints_round
