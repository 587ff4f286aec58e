#include "render_core/display/effect_calls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/default_flight.hpp"
#include "tests/support/free_view.hpp"
#include "tests/support/hills_display.hpp"

namespace tedavis::display::test_effect_calls {
namespace {

using effects::Effect;
using Kind = effects::EffectCall::Kind;

design::DesignSettings design_with_everything() {
    design::DesignSettings design;
    design.terrain.style.sketch.silhouettes = 0.7;
    design.terrain.style.sketch.ridges = 0.2;
    design.terrain.style.shade.follows_sun = true;
    design.terrain.style.texture = design::TerrainTexture::image;
    design.sky.haze_distance_m = 50'000;
    design.terrain.style.grid.spacing_m = 1000;
    design.data.ground.is_shown = design.data.adjacent.is_shown = true;
    design::FocusSettings focus;
    focus.terrain.brightness = 0.4;
    focus.terrain.blur_px = 6;
    static_cast<void>(design.foci.try_push_back(focus));
    return design;
}

class EffectCalls : public ::testing::Test {
protected:
    EffectCalls() {
        decisions_.show_terrain = decisions_.show_warning_colors = true;
        facts_.asked = asked_effects(design_with_everything());
        facts_.is_near = true;
        facts_.light = policy::LightSource::sun;
        facts_.drape = DrapeState::shown;
        facts_.ground_data = facts_.adjacent = GroundDataState::shown;
        facts_.adjacent_maps = 1;
        facts_.haze_per_m = 1e-5;
        facts_.farthest_m = 30'000;
    }
    [[nodiscard]] effects::EffectCall call(Effect effect) const { return effect_calls(facts_)[effect]; }

    policy::DisplayDecisions decisions_;
    EffectFacts facts_{{}, {}, {}, decisions_};
};

TEST_F(EffectCalls, WhatIsThereAndHasAPlaceIsCalledFor) {
    for (const Effect effect : {Effect::terrain, Effect::warning_colors, Effect::silhouettes, Effect::moving_sun, Effect::drape,
                                Effect::haze, Effect::surface_grid, Effect::ground_data, Effect::adjacent})
        EXPECT_EQ(call(effect).kind, Kind::called) << effects::entry_of(effect).name;
    facts_.asked = asked_effects([] {
        design::DesignSettings plain;
        plain.terrain.style.sketch = {};
        plain.sky.haze_distance_m = 0;
        return plain;
    }());
    for (const Effect effect : {Effect::silhouettes, Effect::moving_sun, Effect::drape, Effect::haze, Effect::ground_data,
                                Effect::adjacent, Effect::ridges, Effect::plain_color})
        EXPECT_EQ(call(effect).kind, Kind::not_asked_for) << effects::entry_of(effect).name;
}

TEST(EffectsInReserve, AreThoseWhoseProgramsAreThere) {
    design::DesignSettings design = design_with_everything();
    EXPECT_TRUE(effects_in_reserve(design).has(Effect::ridges));
    design.terrain.style.sketch.ridges = 0;
    EXPECT_FALSE(effects_in_reserve(design).has(Effect::ridges));
    EXPECT_FALSE(effects_in_reserve(design).has(Effect::plain_color));
}

TEST(WithoutEffect, ADesignAsksForEverythingButThat) {
    design::DesignSettings whole = design_with_everything();
    for (const Effect effect :
         {Effect::depth_of_field, Effect::antialiasing, Effect::panel_lighting, Effect::stereo, Effect::cross_fade,
          Effect::soft_shadows, Effect::volumetric_light, Effect::saliency, Effect::clutter}) {
        EXPECT_FALSE(asked_effects(whole).has(effect));
        whole = with_effect(whole, effect);
    }
    const effects::EffectSet asked = asked_effects(whole);
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto left_out = static_cast<Effect>(n);
        const effects::EffectSet without = asked_effects(without_effect(whole, left_out));
        for (std::size_t m = 0; m < effects::kEffectCount; ++m) {
            const auto effect = static_cast<Effect>(m);
            const bool always = effect == Effect::terrain || effect == Effect::warning_colors;
            EXPECT_EQ(without.has(effect), asked.has(effect) && (effect != left_out || always))
                << effects::entry_of(effect).name << " without " << effects::entry_of(left_out).name;
        }
    }
    EXPECT_FALSE(without_effect(whole, Effect::warning_colors).warning_colors);
    const design::DesignSettings air = with_effect(whole, Effect::aerial_perspective);
    EXPECT_TRUE(asked_effects(air).has(Effect::aerial_perspective));
    EXPECT_TRUE(asked_effects(without_effect(air, Effect::aerial_perspective)).has(Effect::haze)) << "as before";
}

TEST_F(EffectCalls, WithoutTerrainNothingIsCalledFor) {
    decisions_.show_terrain = false;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) EXPECT_NE(call(static_cast<Effect>(n)).kind, Kind::called);
    EXPECT_EQ(call(Effect::terrain).why, "removed by the failure policy");
}

TEST_F(EffectCalls, WhatLacksItsInputSaysWhich) {
    facts_.drape = DrapeState::not_in_database;
    facts_.light = policy::LightSource::no_date;
    facts_.ground_data = GroundDataState::out_of_date;
    facts_.adjacent_maps = 0;
    EXPECT_EQ(call(Effect::drape).why, "the terrain database has no image");
    EXPECT_EQ(call(Effect::moving_sun).why, "the time of the flight is no date; name sun_utc in the design");
    EXPECT_EQ(call(Effect::ground_data).why, "the data are not valid at this time");
    EXPECT_EQ(call(Effect::adjacent).why, "there is no room beside the symbology and the legends");
    for (const Effect effect : {Effect::drape, Effect::moving_sun, Effect::ground_data, Effect::adjacent})
        EXPECT_EQ(call(effect).kind, Kind::no_input);
}

TEST_F(EffectCalls, ClutterIsMeasuredWhereSomethingGivesWay) {
    facts_.asked.add(Effect::clutter);
    EXPECT_EQ(call(Effect::clutter).kind, Kind::not_called_for);
    EXPECT_EQ(call(Effect::clutter).why, "nothing is shown that gives way");
    facts_.has_what_gives_way = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::called);
    facts_.is_stereo = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::no_input);
    facts_.shows_clutter = true;
    EXPECT_EQ(call(Effect::clutter).kind, Kind::called) << "as a view";
}

TEST(AskedEffects, ABudgetOfClutterAsksForItsMeasure) {
    design::DesignSettings design = design_with_everything();
    EXPECT_FALSE(asked_effects(design).has(Effect::clutter));
    design.priority.clutter_budget = 0.2;
    EXPECT_FALSE(asked_effects(design).has(Effect::clutter)) << "nothing comes first";
    design.priority.is_stated = true;
    EXPECT_TRUE(asked_effects(design).has(Effect::clutter));
    EXPECT_EQ(without_effect(design, Effect::clutter).priority.clutter_budget, 1);
}

TEST_F(EffectCalls, FromFarAwayThereIsNeitherHazeNorSilhouette) {
    facts_.is_near = false;
    facts_.haze_per_m = 0;
    EXPECT_EQ(call(Effect::silhouettes).kind, Kind::not_called_for);
    EXPECT_EQ(call(Effect::haze).kind, Kind::not_called_for);
}

TEST_F(EffectCalls, ContextIsThereWhereAFocusIs) {
    for (const Effect effect : {Effect::focus_ground, Effect::focus_blur}) {
        EXPECT_EQ(call(effect).kind, Kind::not_called_for);
        EXPECT_EQ(call(effect).why, "no focus is anywhere");
    }
    facts_.has_foci = true;
    facts_.context_blur_px = 6;
    EXPECT_EQ(call(Effect::focus_ground).kind, Kind::called);
    EXPECT_EQ(call(Effect::focus_blur).kind, Kind::called);
    EXPECT_EQ(call(Effect::focus_blur).bound, 6);
    facts_.reads_distances = true;
    EXPECT_EQ(call(Effect::focus_blur).kind, Kind::no_input);
    decisions_.unusual_attitude = true;
    for (const Effect effect : {Effect::focus_ground, Effect::focus_blur})
        EXPECT_EQ(call(effect).kind, Kind::not_called_for) << "the recovery sees all of the ground";
}

/// Brightness stands for blur where the device has no second picture, or its alpha is another's.
TEST(PossibleDesign, IsDarkerRoundFociWhereItCannotBlur) {
    design::DesignSettings design = design_with_everything();
    effects::DeviceSettings device;
    device.capability.gl.calls = effects::CallClass::es3;
    device.capability.off_screen_pictures = 2;
    const auto context = [&] { return terrain_of_context(possible_design(design, device).foci); };
    EXPECT_TRUE(reads_distances(design));
    EXPECT_EQ(context().blur_px, 0);
    EXPECT_DOUBLE_EQ(context().brightness, 0.4 * draw::kBlurAsBrightness);
    design.terrain.style.sketch.silhouettes = 0;
    EXPECT_EQ(context().blur_px, 6);
    EXPECT_EQ(context().brightness, 0.4);
    device.capability.off_screen_pictures = 1;
    EXPECT_EQ(context().blur_px, 0);
    EXPECT_DOUBLE_EQ(context().brightness, 0.4 * draw::kBlurAsBrightness);
    device.forbidden.add(Effect::focus_ground);
    EXPECT_FALSE(context().is_any()) << "nothing may stand for it";
}

TEST(PossibleDesign, HasLinesWhereTheContextHasNothingElse) {
    design::DesignSettings design;
    ASSERT_TRUE(design.foci.try_push_back({}));
    design.terrain.style.sketch = {};
    EXPECT_EQ(possible_design(design, {}).terrain.style.sketch.contours, 0);
    design.foci[0].terrain.sketch_outside = true;
    EXPECT_GT(possible_design(design, {}).terrain.style.sketch.contours, 0);
    design.terrain.style.sketch.hatching = 0.2;
    EXPECT_EQ(possible_design(design, {}).terrain.style.sketch.contours, 0) << "it has lines of its own";
}

TEST_F(EffectCalls, HazeIsBoundedByTheFarthestGround) {
    EXPECT_NEAR(call(Effect::haze).bound, 1 - std::exp(-0.3), 1e-12);
    facts_.farthest_m = std::numeric_limits<double>::infinity();
    EXPECT_EQ(call(Effect::haze).bound, 1);
    EXPECT_EQ(haze_bound(1e-5, 0), 0);
}

TEST(PossibleDesign, IsTheDesignWithWhatStandsIn) {
    const design::DesignSettings design = design_with_everything();
    effects::DeviceSettings device;
    EXPECT_EQ(possible_design(design, device).terrain.style.sketch.silhouettes, 0.7);
    device.capability.depth24_targets = false;
    const design::SketchSettings sketch = possible_design(design, device).terrain.style.sketch;
    EXPECT_EQ(sketch.silhouettes, 0);
    EXPECT_EQ(sketch.ridges, 0.7) << "the stronger of both";
    for (const Effect effect :
         {Effect::moving_sun, Effect::drape, Effect::haze, Effect::surface_grid, Effect::ground_data, Effect::adjacent})
        device.forbidden.add(effect);
    const design::DesignSettings bare = possible_design(design, device);
    EXPECT_FALSE(bare.terrain.style.shade.follows_sun);
    EXPECT_EQ(bare.terrain.style.texture, design::TerrainTexture::plain);
    EXPECT_EQ(bare.sky.haze_distance_m, 0);
    EXPECT_EQ(bare.terrain.style.grid.spacing_m, 0);
    EXPECT_FALSE(bare.data.ground.is_shown);
    EXPECT_FALSE(bare.data.adjacent.is_shown);
}

TEST_F(EffectCalls, AirStandsInTheHazesPlaceAndIsBoundedAsItIs) {
    design::DesignSettings design = design_with_everything();
    design.sky.air.is_shown = true;
    facts_.asked = asked_effects(design);
    facts_.air = design.sky.air;
    EXPECT_EQ(call(Effect::haze).kind, Kind::not_asked_for);
    EXPECT_EQ(call(Effect::aerial_perspective).kind, Kind::called);
    EXPECT_EQ(call(Effect::aerial_perspective).bound, air_bound(design.sky.air, 30'000));
    EXPECT_GT(air_bound(design.sky.air, 30'000), air_bound(design.sky.air, 3'000));
    EXPECT_EQ(air_bound(design.sky.air, 0), 0);
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::aerial_perspective).kind, Kind::not_called_for);
}

TEST_F(EffectCalls, BlurIsBoundedByNearestAndFarthestGround) {
    facts_.asked.add(Effect::depth_of_field);
    facts_.nearest_m = 1000;
    facts_.focus = {true, 500, 40'000, 6};
    EXPECT_EQ(call(Effect::depth_of_field).bound, 0) << "all of it is in focus";
    facts_.focus = {true, 500, 10'000, 6};
    EXPECT_NEAR(call(Effect::depth_of_field).bound, 6 * (1 - 10'000.0 / 30'000), 1e-12);
    facts_.focus = {true, 3000, 40'000, 6};
    EXPECT_EQ(call(Effect::depth_of_field).bound, 6) << "nearer than half of the focus the blur grows no more";
    EXPECT_EQ(blur_bound({true, 0, 1000, 6}, 0, std::numeric_limits<double>::infinity()), 6);
    facts_.focus.is_known = false;
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::no_input);
    facts_.focus = {};
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::called) << "what the device lacks is said by the planner";
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::depth_of_field).kind, Kind::not_called_for);
}

TEST_F(EffectCalls, EachEyesPictureIsBoundedByTheParallax) {
    facts_.asked.add(Effect::stereo);
    facts_.parallax_px = 7;
    EXPECT_EQ(call(Effect::stereo).kind, Kind::called);
    EXPECT_EQ(call(Effect::stereo).bound, 7);
    facts_.is_near = false;
    EXPECT_EQ(call(Effect::stereo).kind, Kind::not_called_for);
}

TEST_F(EffectCalls, InAnUnusualAttitudeNothingDistracts) {
    decisions_.unusual_attitude = true;
    facts_.fade_share = 1;
    facts_.parallax_px = 9;
    for (const Effect effect : {Effect::cross_fade, Effect::stereo, Effect::depth_of_field}) {
        facts_.asked.add(effect);
        EXPECT_EQ(call(effect).why, "removed by the failure policy") << effects::entry_of(effect).name;
    }
    EXPECT_EQ(call(Effect::terrain).kind, Kind::called);
}

TEST_F(EffectCalls, AFadeLastsWhileSomethingIsLeftOfTheSceneAsItWas) {
    facts_.asked.add(Effect::cross_fade);
    EXPECT_EQ(call(Effect::cross_fade).kind, Kind::not_called_for);
    facts_.fade_share = 0.25;
    EXPECT_EQ(call(Effect::cross_fade).kind, Kind::called);
    EXPECT_EQ(call(Effect::cross_fade).bound, 0.25);
}

TEST_F(EffectCalls, ThePanelIsDimmedWithOrWithoutTerrain) {
    facts_.asked.add(Effect::panel_lighting);
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::not_called_for) << "by day";
    facts_.panel.white = {0.9, 0.8, 0.7};
    EXPECT_NEAR(call(Effect::panel_lighting).bound, 0.3, 1e-12);
    decisions_.show_terrain = false;
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::called);
    facts_.panel = {{1, 1, 1}, false};
    EXPECT_EQ(call(Effect::panel_lighting).kind, Kind::no_input);
}

TEST(PossibleDesign, HasNoViewEffectsWhereThereIsNoSecondPicture) {
    design::DesignSettings design;
    design.effects.antialiasing = true;
    design.effects.depth_of_field.blur_px = 4;
    effects::DeviceSettings device;
    device.capability.gl.calls = effects::CallClass::es3;
    device.capability.off_screen_pictures = 2;
    EXPECT_TRUE(possible_design(design, device).effects.antialiasing);
    EXPECT_EQ(possible_design(design, device).effects.depth_of_field.blur_px, 4);
    device.capability.off_screen_pictures = 1;
    EXPECT_FALSE(possible_design(design, device).effects.antialiasing);
    EXPECT_EQ(possible_design(design, device).effects.depth_of_field.blur_px, 0);
    design.effects.stereo.mode = design::StereoMode::anaglyph;
    EXPECT_EQ(possible_design(design, device).effects.stereo.mode, design::StereoMode::none);
}

TEST(PossibleDesign, HazeStandsInForAir) {
    design::DesignSettings design;
    design.sky.air.is_shown = true;
    effects::DeviceSettings device;
    device.capability.gl.calls = effects::CallClass::es3;
    EXPECT_TRUE(possible_design(design, device).sky.air.is_shown);
    EXPECT_EQ(possible_design(design, device).sky.haze_distance_m, 0) << "never both";
    device.capability.gl.calls = effects::CallClass::sc2;
    EXPECT_FALSE(possible_design(design, device).sky.air.is_shown);
    EXPECT_EQ(possible_design(design, device).sky.haze_distance_m, design.sky.haze_distance_m);
}

constexpr std::uint32_t kWidth = 200, kHeight = 150;

/// Straight down from 2 km: no ground is farther than some 3 km.
std::vector<std::uint8_t> seen_from_above(double haze_distance_m, bool is_forced, EffectState& haze) {
    test_support::MemoryBytes bytes(test_support::hills().image);
    design::DesignSettings design = test_support::shipped_design("default");
    design.sky.haze_distance_m = haze_distance_m;
    design.sky.haze = {255, 255, 255};
    test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, design);
    headless.display().force_effects(is_forced);
    const flight::AircraftState aircraft = test_support::aircraft_over_hills(3000);
    const earth::Geodetic& place = aircraft.own_ship.position;
    const glm::dmat3 body = earth::body_axes(place.latitude_rad, place.longitude_rad, 0, base::radians(-85), 0);
    headless.display().set_free_view(test_support::free_view(earth::to_ecef(place), body, kWidth, kHeight, 50));
    std::vector<std::uint8_t> rgba = test_support::settled_pixels(headless, aircraft, test_support::kHillsNow);
    EXPECT_GT(headless.display().record().terrain.triangles, 100u);
    haze = EffectState::replaced;
    for (const EffectRecord& effect : headless.display().record().effects)
        if (effect.name.view() == "haze") haze = effect.state;
    return rgba;
}

int largest_step(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(int{a[n]} - int{b[n]}));
    return largest;
}

TEST(EffectPictures, HazeThatIsLeftOutIsNotMissed) {
    EffectState haze{};
    const auto planned = seen_from_above(9e5, false, haze);
    EXPECT_EQ(haze, EffectState::skipped);
    const auto forced = seen_from_above(9e5, true, haze);
    EXPECT_EQ(haze, EffectState::run);
    EXPECT_LE(largest_step(planned, forced), 1);
    const auto thick = seen_from_above(4e4, false, haze);
    EXPECT_EQ(haze, EffectState::run) << "control";
    EXPECT_GT(largest_step(planned, thick), 5) << "control: it would be missed";
}

}  // namespace
}  // namespace tedavis::display::test_effect_calls
