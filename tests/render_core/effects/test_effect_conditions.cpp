#include "render_core/effects/effect_conditions.hpp"

#include <gtest/gtest.h>

#include "tests/render_core/effects/requesting_frame.hpp"

namespace tedavis::effects::test_effect_conditions {
namespace {

using Kind = EffectRequest::Kind;
using EffectConditions = test_support::RequestingFrame;

TEST_F(EffectConditions, WhatLacksItsInputSaysWhich) {
    facts_.image = {false, "the terrain database has no image"};
    facts_.light_has_date = false;
    facts_.ground_data = {false, "the data are not valid at this time"};
    facts_.maps_drawn = 0;
    EXPECT_EQ(call(Effect::drape).why, "the terrain database has no image");
    EXPECT_EQ(call(Effect::moving_sun).why, "the time of the flight is no date; name sun_utc in the design");
    EXPECT_EQ(call(Effect::ground_data).why, "the data are not valid at this time");
    EXPECT_EQ(call(Effect::adjacent).why, "there is no room beside the symbology and the legends");
    for (const Effect effect : {Effect::drape, Effect::moving_sun, Effect::ground_data, Effect::adjacent})
        EXPECT_EQ(call(effect).kind, Kind::no_input);
}

TEST_F(EffectConditions, ClutterIsMeasuredWhereSomethingGivesWay) {
    facts_.asked.add(Effect::clutter);
    EXPECT_EQ(call(Effect::clutter).kind, Kind::not_applicable);
    EXPECT_EQ(call(Effect::clutter).why, "nothing is shown that gives way");
    facts_.has_declutterable_data = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::applicable);
    facts_.is_stereo = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::no_input);
    facts_.shows_clutter = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::applicable) << "as a view";
}

TEST_F(EffectConditions, FromFarAwayThereIsNeitherHazeNorSilhouette) {
    facts_.is_near = false;
    facts_.has_haze = false;
    EXPECT_EQ(call(Effect::silhouettes).kind, Kind::not_applicable);
    EXPECT_EQ(call(Effect::haze).kind, Kind::not_applicable);
}

TEST_F(EffectConditions, ContextIsThereWhereAFocusIs) {
    for (const Effect effect : {Effect::focus_ground, Effect::focus_blur}) {
        EXPECT_EQ(call(effect).kind, Kind::not_applicable);
        EXPECT_EQ(call(effect).why, "no focus is anywhere");
    }
    facts_.has_foci = true;
    facts_.context_blur_px = 6;
    EXPECT_EQ(call(Effect::focus_ground).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::focus_blur).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::focus_blur).bound, 6);
    facts_.reads_distances = true;
    EXPECT_EQ(call(Effect::focus_blur).kind, Kind::no_input);
    facts_.is_unusual_attitude = true;
    for (const Effect effect : {Effect::focus_ground, Effect::focus_blur})
        EXPECT_EQ(call(effect).kind, Kind::not_applicable) << "the recovery sees all of the ground";
}

TEST_F(EffectConditions, AirStandsInTheHazesPlaceAndIsBoundedAsItIs) {
    design::DesignSettings design = test_support::design_with_everything();
    design.sky.air.is_shown = true;
    facts_.asked = asked_effects(design);
    facts_.air_bound = 0.7;
    EXPECT_EQ(call(Effect::haze).kind, Kind::not_asked_for);
    EXPECT_EQ(call(Effect::aerial_perspective).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::aerial_perspective).bound, 0.7);
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::aerial_perspective).kind, Kind::not_applicable);
}

TEST_F(EffectConditions, BlurIsBoundedByItsWidest) {
    facts_.asked.add(Effect::depth_of_field);
    facts_.focus_is_known = true;
    facts_.focus_blur_px = 6;
    facts_.widest_blur_px = 4.5;
    EXPECT_EQ(call(Effect::depth_of_field).bound, 4.5);
    facts_.focus_is_known = false;
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::no_input);
    facts_.focus_blur_px = 0;
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::applicable) << "what the device lacks is said by the planner";
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::not_applicable);
}

TEST_F(EffectConditions, EachEyesPictureIsBoundedByTheParallax) {
    facts_.asked.add(Effect::stereo);
    facts_.parallax_px = 7;
    EXPECT_EQ(call(Effect::stereo).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::stereo).bound, 7);
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::stereo).kind, Kind::not_applicable);
}

TEST_F(EffectConditions, AFadeLastsWhileSomethingIsLeftOfTheSceneAsItWas) {
    facts_.asked.add(Effect::cross_fade);
    EXPECT_EQ(call(Effect::cross_fade).kind, Kind::not_applicable);
    facts_.fade_share = 0.25;
    EXPECT_EQ(call(Effect::cross_fade).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::cross_fade).bound, 0.25);
}

TEST_F(EffectConditions, ThePanelIsDimmedWithOrWithoutTerrain) {
    facts_.asked.add(Effect::panel_lighting);
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::not_applicable) << "by day";
    facts_.panel_dimming = 0.3;
    EXPECT_EQ(call(Effect::panel_lighting).bound, 0.3);
    facts_.shows_terrain = false;
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::applicable);
    facts_.panel_has_date = false;
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::no_input);
}

/// Light shafts lie in air or haze, whose part they take.
TEST_F(EffectConditions, LightShaftsTakeTheirPartOfTheAir) {
    facts_.asked.add(Effect::volumetric_light);
    facts_.shadows = ShadowState::cast;
    facts_.shadow_in_air = 0.5;
    EXPECT_EQ(call(Effect::volumetric_light).bound, 0.5 * facts_.haze_bound);
    facts_.air_bound = 0.8;
    facts_.has_air = true;
    EXPECT_EQ(call(Effect::volumetric_light).bound, 0.5 * facts_.haze_bound) << "the design asks for no air";
    facts_.asked.add(Effect::aerial_perspective);
    EXPECT_EQ(call(Effect::volumetric_light).bound, 0.5 * 0.8);
    facts_.has_air = facts_.has_haze = false;
    EXPECT_EQ(call(Effect::volumetric_light).kind, Kind::not_applicable);
    EXPECT_EQ(call(Effect::volumetric_light).why, "there is neither air nor haze that scatters light");
}

TEST_F(EffectConditions, ShadowsFallWhereSomethingCastsThem) {
    facts_.asked.add(Effect::soft_shadows);
    EXPECT_EQ(call(Effect::soft_shadows).kind, Kind::applicable) << "what the device lacks is said by the planner";
    for (const ShadowState state : {ShadowState::sun_too_low, ShadowState::values_on_ground, ShadowState::nothing_casts}) {
        facts_.shadows = state;
        EXPECT_EQ(call(Effect::soft_shadows).kind, Kind::not_applicable);
        EXPECT_FALSE(call(Effect::soft_shadows).why.empty());
    }
    facts_.shadows = ShadowState::cast;
    facts_.widest_shadow_px = 12;
    EXPECT_EQ(call(Effect::soft_shadows).bound, 12);
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::soft_shadows).kind, Kind::not_applicable);
}

}  // namespace
}  // namespace tedavis::effects::test_effect_conditions
