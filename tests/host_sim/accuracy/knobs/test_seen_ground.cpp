#include "host_sim/accuracy/knobs/seen_ground.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_seen_ground {
namespace {

/// A place lies where its pixel looks: found by rays, and projected again.
TEST(SeenGround, PlacesAreProjectedOntoTheirPixels) {
    const test_support::ShippedKnobGround shipped;
    TracedShotPlan plan;
    plan.pose = KnobFlight(shipped.ground).pose_at(100);
    plan.width = 64;
    plan.height = 36;
    const std::vector<SeenPlace> places = seen_ground(shipped.ground, plan);
    ASSERT_GT(places.size(), 200u);
    const terrain::View view = view_of(shipped.ground, plan);
    terrain::View aside = view;
    aside.eye += 20.0 * view.right;
    double worst = 0, worst_aside = 0;
    for (const SeenPlace& place : places) {
        const glm::dvec2 middle(place.x + 0.5 - 0.5 * plan.width, place.y + 0.5 - 0.5 * plan.height);
        worst = std::max(worst, glm::distance(*pixel_at(view, place.position), middle));
        worst_aside = std::max(worst_aside, glm::distance(*pixel_at(aside, place.position), middle));
    }
    EXPECT_LT(worst, 0.05);
    EXPECT_GT(worst_aside, 0.1) << "control: another eye";
    EXPECT_FALSE(pixel_at(view, view.eye - view.forward)) << "behind the eye";
}

TEST(SeenGround, LeavesOutPosesThatShowNone) {
    const test_support::ShippedKnobGround shipped;
    AircraftPose level = KnobFlight(shipped.ground).pose_at(100), up = level, low = level;
    up.pitch_deg = 80;
    low.pitch_deg = -60;
    low.altitude_msl_m = shipped.ground.highest_m() + 100;
    const std::vector<SeenPose> seen = seen_poses(shipped.ground, {up, low, level});
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_EQ(poses_of(seen)[0].pitch_deg, -60);
    EXPECT_EQ(seen[0].places.size(), SeenGrid().across * SeenGrid().down) << "nothing but ground";
    test_support::expect_user_error([&] { static_cast<void>(seen_poses(shipped.ground, {up})); },
                                    "no pose of the flight shows ground");
}

}  // namespace
}  // namespace tedavis::host_sim::test_seen_ground
