#include <gtest/gtest.h>

#include <memory>

#include "render_core/display/planner/frame_planner.hpp"
#include "tests/support/display/hills_planner.hpp"

namespace tedavis::display::test_frame_planner_effects {
namespace {

using effects::Effect;
using test_support::HillsPlanner;
using test_support::kHillsNow;

flight::FrameInput input() {
    flight::FrameInput input;
    input.state = test_support::aircraft_over_hills(1800);
    input.time = kHillsNow;
    return input;
}

TEST(FramePlannerEffects, AnEffectThatTheSceneDoesNotCallForIsSkippedUnlessForced) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.effects.shadows.on_ground = 0.6;  // there are no data that cast any
    auto hills = std::make_unique<HillsPlanner>(design);
    hills->settle(input());
    EXPECT_FALSE(hills->plan(input(), hills->memory)->effects.runs(Effect::soft_shadows));
    EXPECT_TRUE(hills->plan(input(), hills->memory)->effects.runs(Effect::terrain)) << "control";
}

TEST(FramePlannerEffects, TheBudgetIsToldWhatTheFrameHas) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input());
    const auto frame = hills->plan(input(), hills->memory);
    EXPECT_EQ(frame->counters.triangles, frame->terrain.triangles);
    EXPECT_GT(frame->counters.triangles, 0u);
    EXPECT_NEAR(frame->counters.megapixels, 320 * 240 * 1e-6, 1e-12);
    EXPECT_EQ(frame->counters.elements, 0u) << "there is no scene";
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_effects
