#include "host_sim/scenario/flown_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim::test_flown_history {
namespace {

glm::dvec3 place(const AircraftPose& pose) {
    return earth::to_ecef({base::radians(pose.latitude_deg), base::radians(pose.longitude_deg), {pose.altitude_msl_m}});
}

AircraftPose pose_with(double turn_deg_per_s) {
    AircraftPose pose{46.8, 9.8, 3000, 60};
    pose.time.ns = 1'000'000'000'000;
    pose.flown.seconds = 120;
    pose.flown.speed_mps = 70;
    pose.flown.turn_deg_per_s = turn_deg_per_s;
    pose.flown.accuracy_m = 10;
    pose.flown.accuracy_before_m = 130;
    return pose;
}

TEST(FlownHistory, IsFlownAtItsSpeedUpToThePose) {
    for (const double turn : {0.0, 1.5, -3.0}) {
        const AircraftPose pose = pose_with(turn);
        std::vector<AircraftPose> way = poses_before(pose);
        ASSERT_EQ(way.size(), 60u);
        way.push_back(pose);
        for (std::size_t n = 1; n < way.size(); ++n) {
            EXPECT_NEAR(glm::distance(place(way[n]), place(way[n - 1])), 140, 0.3);
            EXPECT_EQ(way[n].time.ns - way[n - 1].time.ns, 2'000'000'000);
            EXPECT_NEAR(way[n].heading_deg - way[n - 1].heading_deg, 2 * turn, 1e-9);
        }
        EXPECT_NEAR(way[0].flown.accuracy_m, 130, 1e-9);
        EXPECT_GT(way[30].flown.accuracy_m, way[50].flown.accuracy_m);
    }
}

/// A whole circle ends where it began: 360 degrees at 3 degrees a second.
TEST(FlownHistory, ATurnOfTwoMinutesIsACircle) {
    const AircraftPose pose = pose_with(3);
    EXPECT_NEAR(glm::distance(place(poses_before(pose).front()), place(pose)), 0, 5);
    EXPECT_GT(glm::distance(place(poses_before(pose_with(0)).front()), place(pose)), 8000) << "control: straight on";
}

TEST(FlownHistory, WhatFlewNotHasNone) {
    AircraftPose pose = pose_with(0);
    pose.flown.seconds = 0;
    EXPECT_TRUE(poses_before(pose).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_flown_history
