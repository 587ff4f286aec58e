#include "bus/state/own_ship_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::bus::test_own_ship_filter {
namespace {

using base::Duration;
using base::SignalState;

base::Time at(double seconds) { return base::Time{5'000'000'000'000} + Duration::from_seconds(seconds); }

/// Straight flight at `speed` on `track` from a place, told message by message.
void fly(OwnShipFilter& filter, double latitude, double longitude, double track, double speed, double from_s, double to_s,
         bool gnss_height = true) {
    for (double t = from_s; t < to_s; t += 0.1) {
        const double north = speed * std::cos(track) * t;
        const double east = speed * std::sin(track) * t;
        const double lat = latitude + north / earth::meridian_radius_m(latitude);
        filter.add_latitude(lat, at(t));
        filter.add_longitude(earth::wrap_longitude(longitude + east / (earth::prime_vertical_radius_m(lat) * std::cos(lat))),
                             at(t + 0.002));
        if (gnss_height) filter.add_height(HeightSource::ellipsoid, 1500 + 2 * t, at(t + 0.004));
        filter.add_height(HeightSource::standard, 1400 + 2 * t, at(t + 0.006));
        filter.add_ground_speed(speed, at(t + 0.005));
        filter.add_true_track(track, at(t + 0.007));
        filter.add_up_velocity(2, at(t + 0.008));
    }
}

TEST(OwnShipFilter, MissingUntilPositionAndHeightAreThere) {
    OwnShipFilter filter;
    EXPECT_EQ(filter.estimate(at(0)).state, SignalState::missing);
    filter.add_latitude(0.8, at(0));
    filter.add_longitude(0.1, at(0));
    EXPECT_EQ(filter.estimate(at(0)).state, SignalState::missing);
    filter.add_height(HeightSource::ellipsoid, 500, at(0));
    EXPECT_EQ(filter.estimate(at(0)).state, SignalState::valid);
}

TEST(OwnShipFilter, StraightFlightAtManyPlaces) {
    struct Place {
        double latitude;
        double longitude;
    };
    for (const Place place :
         {Place{0.82, 0.17}, Place{-0.6, 2.6}, Place{1.4, -1}, Place{0.3, base::kPi - 1e-6}, Place{0, -base::kPi}}) {
        OwnShipFilter filter;
        fly(filter, place.latitude, place.longitude, 1.0, 80, 0, 10);
        const flight::OwnShipEstimate estimate = filter.estimate(at(10));
        ASSERT_EQ(estimate.state, SignalState::valid);
        const double north = 80 * std::cos(1.0) * 10;
        const double lat = place.latitude + north / earth::meridian_radius_m(place.latitude);
        const double east_m = earth::angle_difference(estimate.position.longitude_rad, place.longitude) *
                              earth::prime_vertical_radius_m(lat) * std::cos(lat);
        EXPECT_NEAR((estimate.position.latitude_rad - lat) * earth::meridian_radius_m(lat), 0, 0.2) << place.latitude;
        EXPECT_NEAR(east_m, 80 * std::sin(1.0) * 10, 0.5) << place.latitude << ' ' << place.longitude;
        EXPECT_NEAR(estimate.position.height.m, 1520, 0.2);
        EXPECT_NEAR(estimate.velocity_north_mps, 80 * std::cos(1.0), 0.2);
        EXPECT_NEAR(estimate.velocity_east_mps, 80 * std::sin(1.0), 0.2);
        EXPECT_NEAR(estimate.velocity_up_mps, 2, 0.1);
        EXPECT_TRUE(estimate.height_is_geometric);
        EXPECT_GE(estimate.position.longitude_rad, -base::kPi);
        EXPECT_LT(estimate.position.longitude_rad, base::kPi);
    }
}

TEST(OwnShipFilter, StaleWhereItStandsStillThenLost) {
    OwnShipFilter filter;
    fly(filter, 0.8, 0.1, 0, 80, 0, 5);
    EXPECT_EQ(filter.estimate(at(5.1)).state, SignalState::valid);
    const flight::OwnShipEstimate stale = filter.estimate(at(5.3));
    EXPECT_EQ(stale.state, SignalState::stale);
    EXPECT_EQ(stale.position.latitude_rad, filter.estimate(at(6)).position.latitude_rad);
    EXPECT_EQ(filter.estimate(at(7.5)).state, SignalState::lost);
    fly(filter, 0.8, 0.1, 0, 80, 8, 8.15);
    EXPECT_EQ(filter.estimate(at(8.2)).state, SignalState::valid);
}

TEST(OwnShipFilter, WithoutGnssHeightPressureAltitudeServesAndSaysSo) {
    OwnShipFilter filter;
    fly(filter, 0.8, 0.1, 0, 80, 0, 5, false);
    flight::OwnShipEstimate estimate = filter.estimate(at(5));
    EXPECT_EQ(estimate.state, SignalState::valid);
    EXPECT_FALSE(estimate.height_is_geometric);
    EXPECT_FALSE(estimate.height_is_on_qnh);
    EXPECT_NEAR(estimate.position.height.m, 1410, 0.2);
    filter.add_height(HeightSource::baro, 1450, at(4.95));
    EXPECT_NEAR(filter.estimate(at(5)).position.height.m, 1450, 1) << "the altimeter's comes before the standard altitude";
    EXPECT_TRUE(filter.estimate(at(5)).height_is_on_qnh);
    filter.add_height(HeightSource::ellipsoid, 1500, at(4.96));
    EXPECT_TRUE(filter.estimate(at(5)).height_is_geometric);
    EXPECT_FALSE(filter.estimate(at(5)).height_is_on_qnh);
}

TEST(OwnShipFilter, InvalidIsSaidAtOnce) {
    OwnShipFilter filter;
    fly(filter, 0.8, 0.1, 0, 80, 0, 5);
    filter.set_height_invalid(HeightSource::ellipsoid);
    EXPECT_FALSE(filter.estimate(at(5)).height_is_geometric) << "the next height serves";
    EXPECT_EQ(filter.estimate(at(5)).state, SignalState::valid);
    filter.set_position_invalid();
    EXPECT_EQ(filter.estimate(at(5)).state, SignalState::invalid);
    fly(filter, 0.8, 0.1, 0, 80, 5, 5.15);
    EXPECT_EQ(filter.estimate(at(5.1)).state, SignalState::valid);
    EXPECT_TRUE(filter.estimate(at(5.1)).height_is_geometric);
}

TEST(OwnShipFilter, ThePoleIsAPlace) {
    OwnShipFilter filter;
    for (int i = 0; i < 50; ++i) {
        filter.add_latitude(base::kPi / 2, at(0.1 * i));
        filter.add_longitude(0.1 * i, at(0.1 * i));
        filter.add_height(HeightSource::ellipsoid, 100, at(0.1 * i));
        filter.add_ground_speed(100, at(0.1 * i));
        filter.add_true_track(0, at(0.1 * i));
    }
    const flight::OwnShipEstimate estimate = filter.estimate(at(4.9));
    EXPECT_TRUE(std::isfinite(estimate.position.longitude_rad));
    EXPECT_NEAR(estimate.position.latitude_rad, base::kPi / 2, 1e-3);
}

}  // namespace
}  // namespace tedavis::bus::test_own_ship_filter
