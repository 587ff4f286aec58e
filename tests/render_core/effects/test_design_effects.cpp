#include "render_core/effects/design_effects.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/full_design.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::effects::test_design_effects {
namespace {

using design::Antialiasing;
using test_support::design_with_everything;

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
    const EffectSet asked = asked_effects(whole);
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const auto left_out = static_cast<Effect>(n);
        const EffectSet without = asked_effects(without_effect(whole, left_out));
        for (std::size_t m = 0; m < kEffectCount; ++m) {
            const auto effect = static_cast<Effect>(m);
            const bool always = effect == Effect::terrain || effect == Effect::warning_colors;
            EXPECT_EQ(without.has(effect), asked.has(effect) && (effect != left_out || always))
                << row_of(effect).name << " without " << row_of(left_out).name;
        }
    }
    EXPECT_FALSE(without_effect(whole, Effect::warning_colors).warning_colors);
    const design::DesignSettings air = with_effect(whole, Effect::aerial_perspective);
    EXPECT_TRUE(asked_effects(air).has(Effect::aerial_perspective));
    EXPECT_TRUE(asked_effects(without_effect(air, Effect::aerial_perspective)).has(Effect::haze)) << "as before";
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

/// By the shipped devices; `asked` is what a display requests of its design there.
TEST(DesignOn, SmoothsWhatIsLeftToTheDeviceWhereItCanAffordIt) {
    struct Case {
        const char* device;
        Antialiasing stated, possible;
        bool asked;
    };
    const Antialiasing on = Antialiasing::on, off = Antialiasing::off, by_device = Antialiasing::by_device;
    const Case cases[] = {{"desktop", by_device, on, true},     {"desktop", on, on, true},    {"desktop", off, off, false},
                          {"es3-mid", by_device, off, false},   {"es3-mid", on, on, true},    {"es3-mid", off, off, false},
                          {"es2-small", by_device, off, false}, {"es2-small", on, off, true}, {"sc2", by_device, off, false}};
    for (const Case& one : cases) {
        const DeviceSettings device = test_support::shipped_device(one.device);
        design::DesignSettings design;
        design.effects.antialiasing = one.stated;
        const design::DesignSettings decided = design_on(device, design);
        EXPECT_NE(decided.effects.antialiasing, by_device) << one.device;
        EXPECT_EQ(asked_effects(decided).has(Effect::antialiasing), one.asked) << one.device;
        EXPECT_EQ(possible_design(design, device).effects.antialiasing, one.possible) << one.device;
    }
}

TEST(DesignOn, ShippedDesignsOfThePhasesAndMapsLeaveItToTheDevice) {
    DeviceSettings desktop = test_support::shipped_device("desktop");
    for (const char* name :
         {"default", "takeoff", "approach", "cruise", "replanning", "map_north_up", "map_track_up", "orthographic"}) {
        const design::DesignSettings design = test_support::shipped_design(name);
        EXPECT_EQ(design.effects.antialiasing, Antialiasing::by_device) << name;
        EXPECT_EQ(possible_design(design, desktop).effects.antialiasing, Antialiasing::on) << name;
    }
    desktop.forbidden.add(Effect::antialiasing);
    EXPECT_EQ(possible_design(test_support::shipped_design("default"), desktop).effects.antialiasing, Antialiasing::off)
        << "a device that must not";
}

TEST(WithEffect, StandsForWhatIsLeftToTheDevice) {
    design::DesignSettings design;
    design.effects.antialiasing = Antialiasing::by_device;
    EXPECT_FALSE(asked_effects(design).has(Effect::antialiasing)) << "nobody has decided";
    EXPECT_EQ(with_effect(design, Effect::antialiasing).effects.antialiasing, Antialiasing::on);
    EXPECT_EQ(without_effect(design, Effect::antialiasing).effects.antialiasing, Antialiasing::off);
}

/// Brightness stands for blur where the device has no second picture, or its alpha is another's.
TEST(PossibleDesign, IsDarkerRoundFociWhereItCannotBlur) {
    design::DesignSettings design = design_with_everything();
    DeviceSettings device;
    device.capability.gl.calls = CallClass::es3;
    device.capability.off_screen_pictures = 2;
    const auto context = [&] { return terrain_of_context(possible_design(design, device).foci); };
    EXPECT_TRUE(reads_distances(design));
    EXPECT_EQ(context().blur_px, 0);
    EXPECT_DOUBLE_EQ(context().brightness, 0.4 * design::kBlurAsBrightness);
    design.terrain.style.sketch.silhouettes = 0;
    EXPECT_EQ(context().blur_px, 6);
    EXPECT_EQ(context().brightness, 0.4);
    device.capability.off_screen_pictures = 1;
    EXPECT_EQ(context().blur_px, 0);
    EXPECT_DOUBLE_EQ(context().brightness, 0.4 * design::kBlurAsBrightness);
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

TEST(PossibleDesign, IsTheDesignWithWhatStandsIn) {
    const design::DesignSettings design = design_with_everything();
    DeviceSettings device;
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

TEST(PossibleDesign, HasNoViewEffectsWhereThereIsNoSecondPicture) {
    design::DesignSettings design;
    design.effects.antialiasing = Antialiasing::on;
    design.effects.depth_of_field.blur_px = 4;
    DeviceSettings device;
    device.capability.gl.calls = CallClass::es3;
    device.capability.off_screen_pictures = 2;
    EXPECT_EQ(possible_design(design, device).effects.antialiasing, Antialiasing::on);
    EXPECT_EQ(possible_design(design, device).effects.depth_of_field.blur_px, 4);
    device.capability.off_screen_pictures = 1;
    EXPECT_EQ(possible_design(design, device).effects.antialiasing, Antialiasing::off);
    EXPECT_EQ(possible_design(design, device).effects.depth_of_field.blur_px, 0);
    design.effects.stereo.mode = design::StereoMode::anaglyph;
    EXPECT_EQ(possible_design(design, device).effects.stereo.mode, design::StereoMode::none);
}

TEST(PossibleDesign, HazeStandsInForAir) {
    design::DesignSettings design;
    design.sky.air.is_shown = true;
    DeviceSettings device;
    device.capability.gl.calls = CallClass::es3;
    EXPECT_TRUE(possible_design(design, device).sky.air.is_shown);
    EXPECT_EQ(possible_design(design, device).sky.haze_distance_m, 0) << "never both";
    device.capability.gl.calls = CallClass::sc2;
    EXPECT_FALSE(possible_design(design, device).sky.air.is_shown);
    EXPECT_EQ(possible_design(design, device).sky.haze_distance_m, design.sky.haze_distance_m);
}

/// What is measured is read back, which every device can do.
TEST(PossibleDesign, EveryDeviceHoldsABudgetOfClutter) {
    design::DesignSettings design;
    design.priority.is_stated = true;
    design.priority.clutter_budget = 0.2;
    design.effects.saliency.view = design::SaliencyView::heat;
    for (const char* const name : {"es2-small", "es3-mid", "desktop", "sc2"}) {
        DeviceSettings device = test_support::shipped_device(name);
        EXPECT_EQ(possible_design(design, device).priority.held_clutter(), 0.2) << name;
        EXPECT_EQ(possible_design(design, device).effects.saliency.view == design::SaliencyView::none, name == std::string("sc2"))
            << "control: it cannot copy";
        device.forbidden.add(Effect::clutter);
        EXPECT_EQ(possible_design(design, device).priority.held_clutter(), 1) << "control";
    }
}

}  // namespace
}  // namespace tedavis::effects::test_design_effects
