// Oracles: GeographicLib::Geocentric and GeographicLib::Geodesic, independent code with stated accuracies of nanometres.
#include "render_core/earth/wgs84.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "render_core/base/units.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::earth::test_wgs84 {
namespace {

using base::degrees;
using base::kPi;
using base::radians;
using GeographicLib::Geocentric;
using GeographicLib::Geodesic;

Ecef oracle_ecef(double latitude_deg, double longitude_deg, double height_m) {
    Ecef e;
    Geocentric::WGS84().Forward(latitude_deg, longitude_deg, height_m, e.x, e.y, e.z);
    return e;
}

/// Metres between a place and where `from_ecef` says it is, measured in space by the oracle.
double round_trip_error_m(const Ecef& place) {
    const Geodetic g = from_ecef(place);
    return glm::length(oracle_ecef(degrees(g.latitude_rad), degrees(g.longitude_rad), g.height.m) - place);
}

/// The worst round trip of `inverse` over places in a band of heights, crowded at the poles and the equator.
template <class Inverse>
double worst_round_trip_m(double low_m, double high_m, Inverse inverse) {
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        double latitude = degrees(std::asin(2 * unit(random) - 1));
        if (i % 5 == 0) latitude = std::copysign(90 - std::pow(10.0, 1 - 14 * unit(random)), latitude);
        if (i % 5 == 1) latitude = std::copysign(std::pow(10.0, 1 - 14 * unit(random)), latitude);
        const double height = low_m + (high_m - low_m) * unit(random);
        const Ecef place = oracle_ecef(latitude, 360 * unit(random) - 180, height);
        const Geodetic g = inverse(place);
        const Ecef back = oracle_ecef(degrees(g.latitude_rad), degrees(g.longitude_rad), g.height.m);
        worst = std::max({worst, glm::length(back - place), std::abs(g.height.m - height)});
    }
    return worst;
}

TEST(Wgs84, to_ecef_agrees_with_geographiclib) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> latitude(-90, 90), longitude(-180, 180), height(-11000, 100000);
    for (int i = 0; i < 100000; ++i) {
        const double lat = latitude(random), lon = longitude(random), h = height(random);
        ASSERT_LT(glm::length(to_ecef({radians(lat), radians(lon), {h}}) - oracle_ecef(lat, lon, h)), 1e-8);
    }
}

TEST(Wgs84, from_ecef_is_below_a_micrometre_where_aircraft_are) { EXPECT_LT(worst_round_trip_m(-10e3, 100e3, from_ecef), 1e-6); }

TEST(Wgs84, from_ecef_is_below_a_micrometre_down_to_a_thousand_kilometres_from_the_centre) {
    EXPECT_LT(worst_round_trip_m(-kSemiMajorAxis_m + 1.03e6, -10e3, from_ecef), 1e-6);
}

TEST(Wgs84, the_round_trip_check_would_notice_a_spherical_inverse) {
    const auto spherical = [](const Ecef& e) {
        const double r = glm::length(e);
        return Geodetic{std::asin(e.z / r), std::atan2(e.y, e.x), {r - 6371008.8}};
    };
    EXPECT_GT(worst_round_trip_m(-10e3, 100e3, spherical), 1000.0);
}

TEST(Wgs84, from_ecef_on_the_axis) {
    const double polar_radius = kSemiMajorAxis_m * (1 - kFlattening);
    for (double height : {-10e3, -430.0, 0.0, 15000.0, 100e3}) {
        const Geodetic north = from_ecef({0, 0, polar_radius + height});
        EXPECT_EQ(north.latitude_rad, 0.5 * kPi);
        EXPECT_EQ(north.longitude_rad, 0.0);
        EXPECT_NEAR(north.height.m, height, 1e-8);
        const Geodetic south = from_ecef({0, 0, -polar_radius - height});
        EXPECT_EQ(south.latitude_rad, -0.5 * kPi);
        EXPECT_EQ(south.longitude_rad, 0.0);
        EXPECT_NEAR(south.height.m, height, 1e-8);
    }
}

TEST(Wgs84, from_ecef_is_continuous_towards_the_axis) {
    const double polar_radius = kSemiMajorAxis_m * (1 - kFlattening);
    for (int exponent = -320; exponent <= 3; ++exponent) {
        const double off_axis = std::pow(10.0, exponent);
        for (double z : {polar_radius + 300.0, -polar_radius - 300.0}) {
            const Ecef place(-off_axis, off_axis, z);
            EXPECT_LT(round_trip_error_m(place), 1e-8) << "off axis by 1e" << exponent;
            EXPECT_NEAR(from_ecef(place).longitude_rad, radians(135.0), exponent > -300 ? 1e-12 : 1.0);
        }
    }
}

TEST(Wgs84, from_ecef_on_the_equator_and_the_antimeridian) {
    const Geodetic east = from_ecef({-kSemiMajorAxis_m - 500, 0.0, 0.0});
    EXPECT_EQ(east.latitude_rad, 0.0);
    EXPECT_NEAR(std::abs(east.longitude_rad), kPi, 1e-15);
    EXPECT_NEAR(east.height.m, 500.0, 1e-8);
    EXPECT_EQ(wrap_longitude(east.longitude_rad), -kPi);
}

TEST(Wgs84, from_ecef_is_symmetric_about_the_equator) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> coordinate(-7e6, 7e6);
    for (int i = 0; i < 10000; ++i) {
        const Ecef place(coordinate(random), coordinate(random), coordinate(random));
        const Geodetic up = from_ecef(place);
        const Geodetic down = from_ecef({place.x, place.y, -place.z});
        ASSERT_EQ(up.latitude_rad, -down.latitude_rad);
        ASSERT_EQ(up.height.m, down.height.m);
    }
}

TEST(Wgs84, from_ecef_is_defined_near_the_centre) {
    const Geodetic centre = from_ecef({0, 0, 0});
    EXPECT_EQ(centre.latitude_rad, 0.0);
    EXPECT_EQ(centre.longitude_rad, 0.0);
    EXPECT_EQ(centre.height.m, -kSemiMajorAxis_m);
    const Geodetic below = from_ecef({0, 0, -1000});
    EXPECT_EQ(below.latitude_rad, -0.5 * kPi);
    EXPECT_EQ(below.height.m, 1000 - kSemiMajorAxis_m);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-12, 6.4), unit(-1, 1);
    for (int i = 0; i < 50000; ++i) {
        const Ecef place = std::pow(10.0, exponent(random)) * Ecef(unit(random), unit(random), unit(random));
        const Geodetic g = from_ecef(place);
        ASSERT_LE(std::abs(g.latitude_rad), 0.5 * kPi);
        ASSERT_LE(std::abs(g.longitude_rad), kPi);
        ASSERT_TRUE(std::isfinite(g.height.m));
    }
}

TEST(Wgs84, north_east_down_is_a_right_handed_frame_along_the_surface) {
    for (double lat : {-90.0, -45.0, 0.0, 30.0, 89.9, 90.0})
        for (double lon : {-180.0, -90.0, 0.0, 12.5, 179.9}) {
            const glm::dmat3 ned = north_east_down(radians(lat), radians(lon));
            EXPECT_NEAR(glm::determinant(ned), 1.0, 1e-14);
            EXPECT_LT(glm::length(glm::cross(ned[0], ned[1]) - ned[2]), 1e-14);
            const Ecef up = oracle_ecef(lat, lon, 1.0) - oracle_ecef(lat, lon, 0.0);
            EXPECT_LT(glm::length(up + ned[2]), 1e-8) << "down is against growing height";
        }
}

TEST(Wgs84, north_and_east_point_along_growing_latitude_and_longitude) {
    for (double lat : {-70.0, -10.0, 0.0, 47.0, 85.0}) {
        const glm::dmat3 ned = north_east_down(radians(lat), radians(9.8));
        const Ecef here = oracle_ecef(lat, 9.8, 0);
        EXPECT_GT(glm::dot(glm::normalize(oracle_ecef(lat + 1e-4, 9.8, 0) - here), ned[0]), 1 - 1e-9);
        EXPECT_GT(glm::dot(glm::normalize(oracle_ecef(lat, 9.8 + 1e-4, 0) - here), ned[1]), 1 - 1e-9);
    }
}

TEST(Wgs84, body_axes_turn_as_a_pilot_says) {
    const double lat = radians(46.8), lon = radians(9.8);
    const glm::dmat3 ned = north_east_down(lat, lon);
    const auto in_ned = [&](const glm::dmat3& axes, int column) { return glm::transpose(ned) * axes[column]; };
    const glm::dvec3 level_east = in_ned(body_axes(lat, lon, radians(90), 0, 0), 0);
    EXPECT_NEAR(level_east.y, 1.0, 1e-15);
    const glm::dvec3 nose_up = in_ned(body_axes(lat, lon, 0, radians(30), 0), 0);
    EXPECT_NEAR(nose_up.x, std::cos(radians(30)), 1e-15);
    EXPECT_NEAR(nose_up.z, -0.5, 1e-15) << "nose up is against down";
    const glm::dvec3 right_wing = in_ned(body_axes(lat, lon, 0, 0, radians(30)), 1);
    EXPECT_NEAR(right_wing.y, std::cos(radians(30)), 1e-15);
    EXPECT_NEAR(right_wing.z, 0.5, 1e-15) << "right wing down";
}

TEST(Wgs84, body_axes_equal_three_rotations_in_order) {
    const auto turn = [](const glm::dmat3& axes, int first, int second, double angle) {
        glm::dmat3 out = axes;
        out[first] = std::cos(angle) * axes[first] + std::sin(angle) * axes[second];
        out[second] = std::cos(angle) * axes[second] - std::sin(angle) * axes[first];
        return out;
    };
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    for (int i = 0; i < 1000; ++i) {
        const double lat = 0.5 * angle(random), lon = angle(random), heading = angle(random), pitch = 0.5 * angle(random),
                     roll = angle(random);
        const glm::dmat3 yawed = turn(north_east_down(lat, lon), 0, 1, heading);
        const glm::dmat3 pitched = turn(yawed, 2, 0, pitch);  // right-handed about the right wing: down towards forward
        const glm::dmat3 rolled = turn(pitched, 1, 2, roll);
        const glm::dmat3 axes = body_axes(lat, lon, heading, pitch, roll);
        for (int column = 0; column < 3; ++column) ASSERT_LT(glm::length(axes[column] - rolled[column]), 1e-14);
    }
}

TEST(Wgs84, radii_of_curvature_agree_with_short_geodesics) {
    for (double lat : {0.0, 20.0, 47.0, 80.0, 89.0}) {
        double distance = 0;
        Geodesic::WGS84().Inverse(lat - 0.01, 0, lat + 0.01, 0, distance);
        EXPECT_NEAR(meridian_radius_m(radians(lat)), distance / radians(0.02), 0.01);
        const double parallel = glm::length(oracle_ecef(lat, 0, 0) * glm::dvec3(1, 1, 0));
        EXPECT_NEAR(prime_vertical_radius_m(radians(lat)), parallel / std::cos(radians(lat)), 1e-6);
    }
    EXPECT_NEAR(meridian_radius_m(0.5 * kPi), prime_vertical_radius_m(0.5 * kPi), 1e-8) << "at the pole both are equal";
}

/// Worst |distance - geodesic| / allowed over latitudes and azimuths; allowed = max(1e-6 d, 10 nm).
template <class Distance>
double worst_distance_excess(Distance distance) {
    double worst = 0;
    for (double d : {1e-3, 0.1, 10.0, 1e3, 1e4, 5e4, 1e5, 2e5, 4e5})
        for (double lat : {-90.0, -89.0, -47.0, 0.0, 1.0, 20.0, 47.0, 70.0, 85.0, 88.0, 89.0, 89.9, 89.999, 90.0})
            for (double azimuth = 0; azimuth < 360; azimuth += 7.5) {
                double lat2 = 0, lon2 = 0;
                Geodesic::WGS84().Direct(lat, 179.9, azimuth, d, lat2, lon2);
                const double found =
                    distance(Geodetic{radians(lat), radians(179.9), {0}}, Geodetic{radians(lat2), radians(lon2), {0}});
                double truth = 0;
                Geodesic::WGS84().Inverse(lat, 179.9, lat2, lon2, truth);
                worst = std::max(worst, std::abs(found - truth) / std::max(1e-6 * d, 1e-8));
            }
    return worst;
}

TEST(Wgs84, surface_distance_keeps_its_claim_up_to_400_km) { EXPECT_LT(worst_distance_excess(surface_distance_m), 1.0); }

TEST(Wgs84, the_distance_check_would_notice_a_haversine_or_a_bare_chord) {
    const auto haversine = [](const Geodetic& a, const Geodetic& b) {
        const double u = std::sin(0.5 * (b.latitude_rad - a.latitude_rad)),
                     v = std::sin(0.5 * (b.longitude_rad - a.longitude_rad));
        return 2 * 6371008.8 * std::asin(std::sqrt(u * u + std::cos(a.latitude_rad) * std::cos(b.latitude_rad) * v * v));
    };
    const auto chord = [](const Geodetic& a, const Geodetic& b) { return glm::length(to_ecef(a) - to_ecef(b)); };
    EXPECT_GT(worst_distance_excess(haversine), 100.0);
    EXPECT_GT(worst_distance_excess(chord), 100.0);
    test_support::record_worst("A05", 1e-6 * worst_distance_excess(surface_distance_m));
    test_support::record_control("A05", 1e-6 * worst_distance_excess(haversine));
}

TEST(Wgs84, surface_distance_is_symmetric_and_ignores_height) {
    const Geodetic a{radians(46.8), radians(9.8), {2000}}, b{radians(47.1), radians(9.2), {-300}};
    EXPECT_DOUBLE_EQ(surface_distance_m(a, b), surface_distance_m(b, a));
    EXPECT_EQ(surface_distance_m(a, {a.latitude_rad, a.longitude_rad, {9000}}), 0.0);
    Geodetic flat_a = a;
    flat_a.height.m = 0;
    EXPECT_EQ(surface_distance_m(a, b), surface_distance_m(flat_a, b));
}

TEST(Wgs84, up_is_the_normal_of_the_ellipsoid_near_it) {
    double worst = 0, worst_geocentric = 0;
    for (double lat = -90; lat <= 90; lat += 7.5)
        for (const double height_m : {-10'000.0, 0.0, 10'000.0}) {
            const Ecef place = to_ecef({radians(lat), radians(33), {height_m}});
            const glm::dvec3 normal = -north_east_down(radians(lat), radians(33))[2];
            worst = std::max(worst, glm::length(up_at(place) - normal));
            worst_geocentric = std::max(worst_geocentric, glm::length(glm::normalize(place) - normal));
        }
    EXPECT_LT(worst, 1e-5);
    EXPECT_GT(worst_geocentric, 1e-3) << "the check tells it from the direction from the centre";
}

}  // namespace
}  // namespace tedavis::earth::test_wgs84
