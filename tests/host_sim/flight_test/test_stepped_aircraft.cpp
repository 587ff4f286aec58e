#include "host_sim/flight_test/stepped_aircraft.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_stepped_aircraft {
namespace {

using flight::Signal;

TestStart start_at(double heading_deg, double speed_mps, double climb_mps) {
    TestStart start;
    start.latitude_rad = base::radians(46.5);
    start.longitude_rad = base::radians(9.8);
    start.altitude_msl_m = 2000;
    start.heading_rad = base::radians(heading_deg);
    start.speed_mps = speed_mps;
    start.climb_mps = climb_mps;
    return start;
}

/// GeographicLib is the oracle of the way.
TEST(SteppedAircraft, FliesStraightOn) {
    for (const double heading_deg : {0.0, 60.0, 180.0, 275.0}) {
        SteppedAircraft aircraft(start_at(heading_deg, 60, 5));
        aircraft.advance_to(100);
        const SignalSample sample = aircraft.sample();
        double way_m = 0, begin_deg = 0, end_deg = 0;
        GeographicLib::Geodesic::WGS84().Inverse(46.5, 9.8, base::degrees(sample[Signal::latitude]),
                                                 base::degrees(sample[Signal::longitude]), way_m, begin_deg, end_deg);
        EXPECT_NEAR(way_m, 6000, 6) << heading_deg;
        EXPECT_NEAR(std::remainder(begin_deg - heading_deg, 360), 0, 0.1) << heading_deg;
        EXPECT_NEAR(sample[Signal::true_altitude], 2500, 1e-6);
        EXPECT_GT(sample[Signal::ellipsoid_height], 2540) << "the geoid lies some 50 m above the ellipsoid there";
        EXPECT_LT(sample[Signal::ellipsoid_height], 2560);
    }
}

TestStep step_with(std::vector<SignalTarget> hold, std::vector<SignalTarget> ramp = {}, double over_s = 0) {
    TestStep step;
    step.hold = std::move(hold);
    step.ramp = std::move(ramp);
    step.over_s = over_s;
    return step;
}

TEST(SteppedAircraft, ARampIsLinear) {
    SteppedAircraft aircraft(start_at(0, 60, 0));
    aircraft.advance_to(10);
    aircraft.take(step_with({}, {{Signal::ground_speed, 80}}, 20), 10);
    aircraft.advance_to(15);
    EXPECT_NEAR(aircraft.sample()[Signal::ground_speed], 65, 1e-9);
    aircraft.advance_to(40);
    EXPECT_NEAR(aircraft.sample()[Signal::ground_speed], 80, 1e-9);
    EXPECT_NEAR(aircraft.sample()[Signal::true_airspeed], 80, 1e-9) << "it follows in still air";
}

TEST(SteppedAircraft, WhatIsHeldFollowsNothing) {
    SteppedAircraft aircraft(start_at(0, 60, 0));
    aircraft.take(step_with({{Signal::indicated_airspeed, 33}, {Signal::pitch, 0.1}}), 0);
    aircraft.advance_to(5);
    EXPECT_EQ(aircraft.sample()[Signal::indicated_airspeed], 33);
    EXPECT_EQ(aircraft.sample()[Signal::pitch], 0.1);
    EXPECT_EQ(aircraft.sample()[Signal::true_airspeed], 60);
}

TEST(SteppedAircraft, TheRadioAltimeterMeasuresFlatGround) {
    TestStart start = start_at(0, 60, -10);
    EXPECT_FALSE(SteppedAircraft(start).sample().has(Signal::radio_height)) << "there is none";
    start.ground_msl_m = 1000;
    SteppedAircraft aircraft(start);
    EXPECT_FALSE(aircraft.sample().has(Signal::radio_height)) << "out of range";
    aircraft.advance_to(50);
    EXPECT_NEAR(aircraft.sample()[Signal::radio_height], 500, 1e-6);
    aircraft.advance_to(200);
    EXPECT_EQ(aircraft.sample()[Signal::radio_height], 0) << "never below the ground";
}

TEST(SteppedAircraft, ADirectionTurnsTheShorterWay) {
    SteppedAircraft aircraft(start_at(350, 60, 0));
    aircraft.take(step_with({}, {{Signal::true_track, base::radians(10)}}, 10), 0);
    aircraft.advance_to(2.5);
    EXPECT_NEAR(base::degrees(aircraft.sample()[Signal::true_track]), 355, 0.05);
    aircraft.advance_to(7.5);
    EXPECT_NEAR(base::degrees(aircraft.sample()[Signal::true_track]), 5, 0.05);
    aircraft.advance_to(20);
    EXPECT_NEAR(base::degrees(aircraft.sample()[Signal::true_track]), 10, 1e-9);
    aircraft.take(step_with({}, {{Signal::roll, base::radians(170)}}, 10), 20);
    aircraft.advance_to(25);
    EXPECT_NEAR(base::degrees(aircraft.sample()[Signal::roll]), 85, 0.2) << "no direction";
}

TEST(SteppedAircraft, DoesNotDependOnHowOftenItIsAsked) {
    SteppedAircraft often(start_at(60, 60, 3)), once(start_at(60, 60, 3));
    for (int ms = 0; ms <= 10000; ms += 20) often.advance_to(ms / 1000.0);
    once.advance_to(10);
    EXPECT_NEAR(often.sample()[Signal::latitude], once.sample()[Signal::latitude], 1e-14);
}

}  // namespace
}  // namespace tedavis::host_sim::test_stepped_aircraft
