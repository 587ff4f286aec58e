#include "render_core/display/planner/shadow_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/display/shaded_view.hpp"

namespace tedavis::display::test_shadow_plan {
namespace {

using effects::Effect;
using Kind = effects::EffectRequest::Kind;

using Shadows = test_support::ShadedView;

TEST_F(Shadows, AreCalledForWhereSomethingCastsThem) {
    add_plate(1000, 50);
    EXPECT_EQ(call().kind, Kind::applicable);
    EXPECT_GT(plan().widest_px, 50);
    EXPECT_NEAR(plan().frame.top_m, 500, 1);
    EXPECT_EQ(call(Effect::soft_shadows, 0, false).kind, Kind::not_applicable) << "the map's";
}

TEST_F(Shadows, SayWhyTheyAreNotCalledFor) {
    EXPECT_EQ(call().why, "nothing over the ground casts a shadow into the view");
    add_plate(1000, 50);
    groups_ = 0;
    EXPECT_EQ(call().why, "nothing over the ground casts a shadow into the view") << "none of the named roles";
    groups_ = ~0u;
    has_values_ = true;
    EXPECT_EQ(call().why, "the colours of the ground are values");
    has_values_ = false;
    light_.elevation_rad = 0.03;
    EXPECT_EQ(call().why, "the sun stands below 3 degrees");
    light_.elevation_rad = 0.7;
    light_.source = policy::LightSource::sun_too_low;
    EXPECT_EQ(call().why, "the sun stands below 3 degrees") << "though the ground is lit otherwise";
    EXPECT_EQ(call().kind, Kind::not_applicable);
}

TEST_F(Shadows, InTheAirNeedAirThatScattersLight) {
    settings_.in_air = 0.5;
    add_plate(1000, 50);
    EXPECT_EQ(call(Effect::volumetric_light, 0).why, "there is neither air nor haze that scatters light");
    EXPECT_EQ(call(Effect::volumetric_light, 0).kind, Kind::not_applicable);
    EXPECT_EQ(call(Effect::volumetric_light, 0.8).kind, Kind::applicable);
    EXPECT_NEAR(call(Effect::volumetric_light, 0.8).bound, 0.4, 1e-12);
    light_.elevation_rad = 0.03;
    EXPECT_EQ(call(Effect::volumetric_light, 0.8).why, "the sun stands below 3 degrees");
}

TEST_F(Shadows, BehindTheEyeThereAreNone) {
    add_plate(-5000, 50);
    EXPECT_EQ(plan().state, effects::ShadowState::nothing_casts);
}

TEST_F(Shadows, AreBoundedByTheirWidthInThePicture) {
    add_plate(1000, 0.2);
    nearest_m_ = 50'000;
    const effects::EffectRequest far = call();
    EXPECT_LT(far.bound, effects::kUnseenPixels);
    EXPECT_NEAR(far.bound, 2 * 0.2 * std::sqrt(2.0) * view_.focal_px / 50'000, 1e-3);
    effects::PlanInput input;
    input[effects::Effect::soft_shadows] = far;
    effects::DeviceCapability device;
    device.gl.calls = effects::CallClass::es3;
    device.shadow_map_px = 1024;
    EXPECT_FALSE(effects::plan_effects(input, device).runs(effects::Effect::soft_shadows));
    device.shadow_map_px = 0;
    EXPECT_EQ(effects::plan_effects(input, device)[effects::Effect::soft_shadows].replaced_by, effects::Effect::projections);
}

}  // namespace
}  // namespace tedavis::display::test_shadow_plan
