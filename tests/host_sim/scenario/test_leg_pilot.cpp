#include "host_sim/scenario/leg_pilot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim::test_leg_pilot {
namespace {

Scenario calm_scenario() {
    Scenario scenario;
    scenario.strip = {base::radians(36.6), base::radians(-84.2), base::radians(240), 345, 1200, 30};
    scenario.aircraft = {2.5, base::radians(32), base::radians(18), 2.5};
    return scenario;
}

Leg leg(LegKind kind, double speed) {
    Leg result;
    result.kind = kind;
    result.speed_mps = speed;
    result.climb_mps = 10;
    result.acceleration_mps2 = 3;
    result.glide_rad = base::radians(5);
    return result;
}

/// Steps until the leg ends; returns its duration, or -1 after ten minutes.
double fly(LegPilot& pilot, const Leg& flown) {
    pilot.begin(flown);
    for (int i = 1; i < 60'000; ++i) {
        if (pilot.step(flown)) return i * kScenarioStep_s;
    }
    return -1;
}

TEST(LegPilot, StandsAtTheBeginningOfTheStrip) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, FlownAir{});
    const auto before = pilot.state();
    const double distance = earth::surface_distance_m({before.latitude_rad, before.longitude_rad, {}},
                                                      {scenario.strip.latitude_rad, scenario.strip.longitude_rad, {}});
    EXPECT_NEAR(distance, 540, 1);
    EXPECT_NEAR(before.altitude_msl_m, 347.5, 1e-9);
    Leg stand = leg(LegKind::stand, 0);
    stand.duration_s = 5;
    EXPECT_NEAR(fly(pilot, stand), 5, 0.011);
    EXPECT_EQ(pilot.state().latitude_rad, before.latitude_rad);
}

TEST(LegPilot, RollsStraightAlongTheStrip) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, {101325, 0, 15, base::radians(330)});  // crosswind: the ground keeps it straight
    const double duration = fly(pilot, leg(LegKind::roll, 48));
    EXPECT_GT(duration, 48 / 3.0);
    EXPECT_NEAR(pilot.state().altitude_msl_m, 347.5, 1e-6);
    EXPECT_NEAR(earth::angle_difference(std::atan2(pilot.state().east_mps, pilot.state().north_mps), scenario.strip.heading_rad),
                0, 1e-6);
}

TEST(LegPilot, HoldsATrackAgainstTheWind) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, {101325, 0, 10, base::radians(330)});
    (void)fly(pilot, leg(LegKind::roll, 48));
    Leg climb = leg(LegKind::hold, 70);
    climb.heading_rad = scenario.strip.heading_rad;
    climb.altitude_msl_m = 1200;
    const double duration = fly(pilot, climb);
    EXPECT_GT(duration, 80);
    EXPECT_NEAR(pilot.state().altitude_msl_m, 1200, 5);
    EXPECT_NEAR(earth::angle_difference(std::atan2(pilot.state().east_mps, pilot.state().north_mps), climb.heading_rad), 0,
                0.005);
    EXPECT_GT(std::abs(earth::angle_difference(pilot.state().heading_rad, climb.heading_rad)), base::radians(5)) << "it crabs";
    EXPECT_NEAR(pilot.state().airspeed_mps, 70, 0.5);
}

TEST(LegPilot, TurnsWithTheBankOfACoordinatedTurn) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, FlownAir{});
    (void)fly(pilot, leg(LegKind::roll, 48));
    Leg turn = leg(LegKind::hold, 70);
    turn.heading_rad = base::radians(60.5);
    turn.altitude_msl_m = 5000;
    pilot.begin(turn);
    for (int i = 0; i < 1500; ++i) (void)pilot.step(turn);
    const auto before = pilot.state();
    (void)pilot.step(turn);
    const double rate = (pilot.state().heading_rad - before.heading_rad) / kScenarioStep_s;
    EXPECT_GT(std::abs(before.roll_rad), base::radians(25));
    EXPECT_NEAR(std::tan(pilot.state().roll_rad), before.airspeed_mps * rate / base::kStandardGravity, 1e-3);
}

TEST(LegPilot, FliesToAPoint) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, {101325, 0, 8, base::radians(100)});
    (void)fly(pilot, leg(LegKind::roll, 48));
    Leg point = leg(LegKind::fly_to, 70);
    point.latitude_rad = base::radians(36.63);
    point.longitude_rad = base::radians(-84.25);
    point.altitude_msl_m = 800;
    point.capture_m = 200;
    EXPECT_GT(fly(pilot, point), 0);
    EXPECT_LT(earth::surface_distance_m({pilot.state().latitude_rad, pilot.state().longitude_rad, {}},
                                        {point.latitude_rad, point.longitude_rad, {}}),
              201);
}

TEST(LegPilot, LandsOnTheStripAndStops) {
    const Scenario scenario = calm_scenario();
    LegPilot pilot(scenario, {101325, 0, 6, base::radians(270)});
    (void)fly(pilot, leg(LegKind::roll, 48));
    Leg away = leg(LegKind::fly_to, 60);  // downwind, two kilometres beyond the threshold
    away.latitude_rad = base::radians(36.605);
    away.longitude_rad = base::radians(-84.165);
    away.altitude_msl_m = 560;
    away.capture_m = 300;
    ASSERT_GT(fly(pilot, away), 0);
    Leg final = leg(LegKind::final_leg, 50);
    final.until_height_m = 30;
    ASSERT_GT(fly(pilot, final), 0);
    ASSERT_GT(fly(pilot, leg(LegKind::land, 48)), 0);
    const auto stopped = pilot.state();
    EXPECT_EQ(stopped.airspeed_mps, 0);
    EXPECT_NEAR(stopped.altitude_msl_m, 347.5, 0.05);
    const double north = (stopped.latitude_rad - scenario.strip.latitude_rad) * 6.36e6;
    const double east = (stopped.longitude_rad - scenario.strip.longitude_rad) * 6.386e6 * std::cos(scenario.strip.latitude_rad);
    const double along = north * std::cos(scenario.strip.heading_rad) + east * std::sin(scenario.strip.heading_rad);
    const double right = east * std::cos(scenario.strip.heading_rad) - north * std::sin(scenario.strip.heading_rad);
    EXPECT_LT(std::abs(along), 600) << "on the strip";
    EXPECT_LT(std::abs(right), 15) << "on the strip";
}

}  // namespace
}  // namespace tedavis::host_sim::test_leg_pilot
