#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"

#include <gtest/gtest.h>

#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_terrain_tau_knob {
namespace {

TEST(TerrainTauKnob, ErrorsKeepToTheToleranceAndFallWithIt) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_terrain_tau_knob(shipped.quick());
    std::vector<ErrorDistribution> errors;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
        errors.push_back(test_support::errors_of(*knob, level));
        EXPECT_LE(errors.back().max, knob->facts().levels[level].amount) << level;
        EXPECT_GT(errors.back().count, 1000u);
    }
    for (std::size_t level = 1; level < errors.size(); ++level) {
        EXPECT_LT(errors[level].mean, errors[level - 1].mean) << level;
        EXPECT_GT(knob->work(level), knob->work(level - 1)) << "triangles";
    }
    EXPECT_GT(errors.front().max, 1) << "control: a coarse level exceeds what a fine one keeps to";
}

/// What the display states of a frame is never below what is found of it.
TEST(TerrainTauKnob, TheStatedErrorIsAboveEveryFoundOne) {
    const test_support::ShippedKnobGround shipped;
    FlownLevel level;
    level.picture.terrain = shipped.ground.path();
    level.picture.size = kFlownSize;
    level.picture.tau_px = 6;
    FlownPictures pictures({level}, KnobFlight(shipped.ground).poses(5));
    double nearest = 0;
    for (std::size_t pose = 0; pose < 5; ++pose) {
        display::Display& display = pictures.display(0, pose);
        TracedShotPlan plan;
        plan.pose = pictures.poses()[pose];
        plan.width = 40;
        plan.height = 24;
        const double stated = display.record().terrain.worst_error_px;
        for (const SeenPlace& place : seen_ground(shipped.ground, plan)) {
            const double found = terrain_error_px(display, place).value_or(0);
            EXPECT_LE(found, stated) << pose;
            nearest = std::max(nearest, found / stated);
        }
    }
    EXPECT_GT(nearest, 0.1) << "control: the statement is no empty one";
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_tau_knob
