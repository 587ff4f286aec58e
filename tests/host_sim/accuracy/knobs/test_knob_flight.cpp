#include "host_sim/accuracy/knobs/knob_flight.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/shipped_files.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_knob_flight {
namespace {

TEST(KnobFlight, IsTheShippedFlightOverTheShippedTerrain) {
    const test_support::ShippedKnobGround shipped;
    KnobFlight flight(shipped.ground);
    EXPECT_EQ(flight.name(), "the shipped flight");
    const std::string path = resolve_config("default", "scenarios");
    const Scenario scenario = parse_scenario(read_file(path), path);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const ScenarioFlight flown(scenario, scenario.seed, geoid);
    for (const AircraftPose& pose : flight.poses(7)) {
        const auto signals = flown.at(pose.time);
        ASSERT_TRUE(signals);
        EXPECT_NEAR(base::radians(pose.latitude_deg), (*signals)[flight::Signal::latitude], 1e-9);
        EXPECT_NEAR(base::radians(pose.longitude_deg), (*signals)[flight::Signal::longitude], 1e-9);
        EXPECT_NEAR(std::sin(base::radians(pose.heading_deg) - (*signals)[flight::Signal::true_heading]), 0, 1e-6);
    }
    EXPECT_NE(flight.pose_at(100).latitude_deg, flight.pose_at(101).latitude_deg) << "control: it moves";
    const std::string scene = flight.scene();
    EXPECT_EQ(OpenScene(scene).scene().layers().size(), OpenScene(flight.scene()).scene().layers().size());
}

TEST(KnobFlight, MovesToATerrainThatDoesNotHoldIt) {
    const test_support::MadeKnobGround made;
    KnobFlight flight(made.ground);
    EXPECT_EQ(flight.name(), "the shipped flight, moved to the terrain");
    const AircraftPose begin = flight.pose_at(0);
    const glm::dvec3 place = made.ground.space().place(
        earth::to_ecef({base::radians(begin.latitude_deg), base::radians(begin.longitude_deg), {begin.altitude_msl_m}}));
    EXPECT_NEAR(place.x, 0.5 * made.ground.columns(), 0.1 * made.ground.columns());
    EXPECT_NEAR(place.y, 0.5 * made.ground.rows(), 0.1 * made.ground.rows());
    for (const AircraftPose& pose : flight.poses(20)) EXPECT_GT(pose.altitude_msl_m, made.ground.highest_m());
    EXPECT_TRUE(std::filesystem::exists(flight.scene()));
}

/// Northwards from 47 N, 0.001 degrees a step; nothing is valid from 1 s to 5 s.
RecordedPoses made_recording() {
    RecordedPoses recorded;
    recorded.log = "made.log";
    recorded.step_s = 0.1;
    for (int n = 0; n < 60; ++n) {
        if (n > 10 && n < 50) continue;
        AircraftPose pose{47.04 + 1e-5 * n, 9.68, 2600, n % 2 == 0 ? 359.0 : 1.0, -8, 0};
        pose.time = base::Time{} + base::Duration::from_seconds(0.1 * n);
        pose.phase = {flight::Scenario::cruise, 0};
        recorded.valid.push_back(pose);
    }
    return recorded;
}

TEST(KnobFlight, TakesPosesOfARecordedFlightWhereItsPositionIsValid) {
    const test_support::MadeKnobGround made;
    const RecordedPoses recorded = made_recording();
    KnobFlight flight(made.ground, &recorded);
    EXPECT_EQ(flight.name(), "made.log");
    EXPECT_NEAR(flight.duration_s(), 2.1, 1e-9);
    std::vector<double> times;
    for (const AircraftPose& pose : flight.poses(7)) times.push_back((pose.time - flight.begin()).to_seconds());
    ASSERT_EQ(times.size(), 7u);
    for (std::size_t n = 0; n < 7; ++n)
        EXPECT_NEAR(times[n], n < 4 ? 0.1 + 0.3 * static_cast<double>(n) : 5.2 + 0.3 * (static_cast<double>(n) - 4), 1e-9) << n;
    EXPECT_NEAR(flight.pose_at(0.25).latitude_deg, 47.04 + 2.5e-5, 1e-9) << "between two";
    EXPECT_NEAR(std::remainder(flight.pose_at(0.25).heading_deg, 360.0), 0, 1e-6) << "from 359 to 1 degree";
    EXPECT_NEAR(flight.pose_at(3).latitude_deg, 47.0401, 1e-9) << "the last one before the gap";
    EXPECT_NEAR(flight.pose_at(100).latitude_deg, 47.04 + 59e-5, 1e-9);
    EXPECT_EQ(phase_option(flight.pose_at(0)), " --phase cruise");
    EXPECT_TRUE(std::filesystem::exists(flight.scene()));
}

TEST(KnobFlight, WritesPosesAsShotTakesThem) {
    AircraftPose pose;
    pose.latitude_deg = 36.5;
    pose.longitude_deg = -84.25;
    pose.altitude_msl_m = 1200;
    pose.heading_deg = 90;
    EXPECT_EQ(phase_option(pose), "");
    EXPECT_EQ(pose_text(pose), "36.500000,-84.250000,1200.00,90.000,0.000,0.000");
}

}  // namespace
}  // namespace tedavis::host_sim::test_knob_flight
