#include "render_core/effects/effect_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::effects::test_effect_planner {
namespace {

using Kind = EffectRequest::Kind;

class EffectPlanner : public ::testing::Test {
protected:
    [[nodiscard]] FramePlan plan() const { return plan_effects(input_, device_); }

    PlanInput input_;
    DeviceCapability device_;
};

TEST_F(EffectPlanner, WhatIsNotAskedForIsNotSpokenOf) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        EXPECT_EQ(plan()[static_cast<Effect>(n)].state, PlanState::not_asked_for);
        EXPECT_FALSE(plan().runs(static_cast<Effect>(n)));
    }
}

TEST_F(EffectPlanner, WhatIsCalledForRuns) {
    input_[Effect::silhouettes] = {Kind::applicable, ""};
    EXPECT_EQ(plan()[Effect::silhouettes].state, PlanState::run);
    EXPECT_EQ(plan()[Effect::silhouettes].reason, "asked for by the design");
    EXPECT_TRUE(plan().runs(Effect::silhouettes));
    EXPECT_FALSE(plan().runs(Effect::ridges));
    input_[Effect::silhouettes].why = "a reason of its own";
    EXPECT_EQ(plan()[Effect::silhouettes].reason, "a reason of its own");
}

TEST_F(EffectPlanner, WhatTheViewDoesNotCallForIsSkippedEvenWhereItWouldBeReplaced) {
    input_[Effect::silhouettes] = {Kind::not_applicable, "seen from above"};
    device_.depth24_targets = false;
    EXPECT_EQ(plan()[Effect::silhouettes].state, PlanState::skipped);
    EXPECT_EQ(plan()[Effect::silhouettes].reason, "seen from above");
    EXPECT_FALSE(plan().runs(Effect::ridges));
}

TEST_F(EffectPlanner, WhatTheDeviceLacksIsReplacedAndTheReplacementRuns) {
    input_[Effect::silhouettes] = {Kind::applicable, ""};
    device_.depth24_targets = false;
    const PlannedEffect planned = plan()[Effect::silhouettes];
    EXPECT_EQ(planned.state, PlanState::replaced);
    EXPECT_EQ(planned.replaced_by, Effect::ridges);
    EXPECT_EQ(planned.reason, lack_of(Need::depth24_target));
    EXPECT_TRUE(plan().runs(Effect::ridges));
    EXPECT_FALSE(plan().runs(Effect::silhouettes));
}

TEST_F(EffectPlanner, WhatIsForbiddenIsReplacedOrSkipped) {
    for (const Effect effect : {Effect::silhouettes, Effect::drape, Effect::haze, Effect::ground_data}) {
        input_[effect] = {Kind::applicable, ""};
        input_.forbidden.add(effect);
    }
    EXPECT_EQ(plan()[Effect::silhouettes].replaced_by, Effect::ridges);
    EXPECT_EQ(plan()[Effect::drape].replaced_by, Effect::plain_color);
    for (const Effect effect : {Effect::haze, Effect::ground_data}) {
        EXPECT_EQ(plan()[effect].state, PlanState::skipped);
        EXPECT_EQ(plan()[effect].reason, "forbidden by the device's file");
    }
}

TEST_F(EffectPlanner, WithoutItsInputSomethingElseStandsInWhateverTheDeviceCanDo) {
    input_[Effect::drape] = {Kind::no_input, "there is no image"};
    input_[Effect::ground_data] = {Kind::no_input, "there is no scene"};
    EXPECT_EQ(plan()[Effect::drape].state, PlanState::replaced);
    EXPECT_EQ(plan()[Effect::drape].replaced_by, Effect::plain_color);
    EXPECT_EQ(plan()[Effect::drape].reason, "there is no image");
    EXPECT_EQ(plan()[Effect::ground_data].state, PlanState::skipped);
    EXPECT_EQ(plan()[Effect::ground_data].reason, "there is no scene");
}

TEST_F(EffectPlanner, WhatTheTimeDoesNotSufficeForIsReplacedByWhatIsInReserve) {
    input_[Effect::silhouettes] = {Kind::applicable, ""};
    input_.too_costly.add(Effect::silhouettes);
    input_.in_reserve.add(Effect::ridges);
    const PlannedEffect planned = plan()[Effect::silhouettes];
    EXPECT_EQ(planned.state, PlanState::replaced);
    EXPECT_EQ(planned.replaced_by, Effect::ridges);
    EXPECT_EQ(planned.reason, "the time does not suffice");
    EXPECT_TRUE(plan().runs(Effect::ridges));
    EXPECT_FALSE(plan().runs(Effect::silhouettes));
}

TEST_F(EffectPlanner, WithoutAReserveWhatTheTimeDoesNotSufficeForIsLeftOut) {
    input_[Effect::silhouettes] = input_[Effect::haze] = {Kind::applicable, ""};
    input_.too_costly.add(Effect::silhouettes);
    input_.too_costly.add(Effect::haze);
    for (const Effect effect : {Effect::silhouettes, Effect::haze}) {
        EXPECT_EQ(plan()[effect].state, PlanState::skipped);
        EXPECT_EQ(plan()[effect].reason, "the time does not suffice");
        EXPECT_EQ(plan()[effect].replaced_by, Effect::count_);
    }
    EXPECT_FALSE(plan().runs(Effect::ridges)) << "its programs are not there";
    EXPECT_EQ(plan().unseen_color(), 0) << "it is not left out for being unseen";
    input_.in_reserve.add(Effect::ridges);
    input_.too_costly.add(Effect::ridges);
    EXPECT_FALSE(plan().runs(Effect::ridges)) << "too dear itself";
}

TEST_F(EffectPlanner, WhatTheDeviceOrTheViewSaysGoesBeforeTheTime) {
    input_.too_costly.add(Effect::silhouettes);
    input_.in_reserve.add(Effect::ridges);
    input_[Effect::silhouettes] = {Kind::not_applicable, "seen from above"};
    EXPECT_EQ(plan()[Effect::silhouettes].reason, "seen from above");
    EXPECT_FALSE(plan().runs(Effect::ridges));
    input_[Effect::silhouettes] = {Kind::applicable, ""};
    input_.forbidden.add(Effect::silhouettes);
    EXPECT_EQ(plan()[Effect::silhouettes].reason, "forbidden by the device's file");
}

TEST_F(EffectPlanner, ColorIsLeftOutUpToOneStepOfEightBits) {
    input_[Effect::haze] = {Kind::applicable, "", kUnseenColor};
    EXPECT_EQ(plan()[Effect::haze].state, PlanState::skipped);
    EXPECT_EQ(plan()[Effect::haze].reason, "too small to be seen");
    EXPECT_EQ(plan()[Effect::haze].bound, kUnseenColor);
    EXPECT_EQ(plan().unseen_color(), kUnseenColor);
    EXPECT_FALSE(plan().runs(Effect::haze));
    input_[Effect::haze].bound = std::nextafter(kUnseenColor, 1);
    EXPECT_TRUE(plan().runs(Effect::haze));
    EXPECT_EQ(plan().unseen_color(), 0);
    EXPECT_EQ(plan()[Effect::haze].bound, 0) << "nothing is left out";
}

TEST_F(EffectPlanner, ABoundThatIsNotKnownLeavesNothingOut) {
    for (const double bound : {std::numeric_limits<double>::infinity(), std::nan("")}) {
        input_[Effect::haze] = {Kind::applicable, "", bound};
        EXPECT_TRUE(plan().runs(Effect::haze)) << bound;
    }
}

TEST_F(EffectPlanner, ContentIsNeverTooSmall) {
    input_[Effect::ground_data] = {Kind::applicable, "", 1e-9};
    EXPECT_TRUE(plan().runs(Effect::ground_data));
    input_[Effect::ground_data].bound = 0;
    EXPECT_FALSE(plan().runs(Effect::ground_data)) << "it shows nothing";
}

TEST_F(EffectPlanner, ForcedEffectsAreNotLeftOutForTheirSize) {
    input_[Effect::haze] = {Kind::applicable, "", 0};
    EXPECT_FALSE(plan().runs(Effect::haze));
    input_.is_forced = true;
    EXPECT_TRUE(plan().runs(Effect::haze));
    input_[Effect::haze].kind = Kind::not_applicable;
    EXPECT_FALSE(plan().runs(Effect::haze)) << "nothing can force what the view has no place for";
}

}  // namespace
}  // namespace tedavis::effects::test_effect_planner
