#include "host_sim/tracing/ground_look.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/commands/option_texts.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_ground_look {
namespace {

AircraftPose over_equator() {
    AircraftPose pose;
    pose.longitude_deg = 0;
    return pose;
}

TEST(SunAt, IsFixedWithoutATime) {
    const SunChoice sun = sun_at(over_equator(), {});
    EXPECT_FALSE(sun.is_too_low);
    EXPECT_NEAR(glm::length(sun.towards), 1, 1e-12);
    EXPECT_LT(sun.towards.x, -0.4) << "from the west";
    EXPECT_LT(sun.towards.y, -0.4) << "from the north: rows run southwards";
    EXPECT_NEAR(sun.towards.z, std::sqrt(0.5), 1e-12);
}

TEST(SunAt, StandsWhereItDoesAtATime) {
    const SunChoice noon = sun_at(over_equator(), time_from("2026-06-21T12:00:00Z"));
    EXPECT_FALSE(noon.is_too_low);
    EXPECT_NEAR(std::asin(noon.towards.z) * 180 / 3.14159265, 90 - 23.4, 0.7);
    EXPECT_LT(noon.towards.y, 0) << "in the north at midsummer";
    const SunChoice morning = sun_at(over_equator(), time_from("2026-03-20T08:00:00Z"));
    EXPECT_GT(morning.towards.x, 0.8) << "in the east";
}

TEST(SunAt, SaysWhenItIsTooLow) {
    const SunChoice night = sun_at(over_equator(), time_from("2026-03-20T23:00:00Z"));
    EXPECT_TRUE(night.is_too_low);
    EXPECT_EQ(night.towards, sun_at(over_equator(), {}).towards);
}

TEST(GroundLook, ColorsHeightsOfTheGround) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    const GroundLook look(ground, sun_at(over_equator(), {}));
    EXPECT_EQ(look.look().ground.lowest, static_cast<float>(ground.lowest_m()));
    EXPECT_EQ(look.look().ground.highest, static_cast<float>(ground.highest_m()));
    EXPECT_GE(look.look().ground.palette.size(), 2u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ground_look
