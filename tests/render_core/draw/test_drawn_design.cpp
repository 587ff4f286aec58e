#include "render_core/draw/drawn_design.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/focus_grounds.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::draw::test_drawn_design {
namespace {

GroundFocusKind with_focus(bool blurs) {
    GroundFocusKind focus;
    focus.foci = 1;
    focus.blurs = blurs;
    return focus;
}

constexpr DrawAbility kShades{true, true, true}, kWithoutDepth{false, true, false}, kEs2{true, false, false};

TEST(DrawnDesign, TheCheapestOutputThatShowsTheStyle) {
    design::DesignSettings design;
    design::TerrainStyle& style = design.terrain.style;
    style.sketch.silhouettes = 1;
    EXPECT_EQ(output_of(design, true), TerrainOutput::code);
    design.sky.air.is_shown = true;
    EXPECT_EQ(output_of(design, true), TerrainOutput::color_and_distance);
    design.sky.air.is_shown = false;
    EXPECT_EQ(output_of(design, false), TerrainOutput::color);
    style.sketch.contours = 1;
    EXPECT_EQ(output_of(design, true), TerrainOutput::color_and_distance);
    style.sketch.silhouettes = 0;
    EXPECT_EQ(output_of(design, true), TerrainOutput::color);
    style.sketch.contours = 0;
    EXPECT_EQ(output_of(design, true), TerrainOutput::code);
    EXPECT_EQ(output_of(design, true, with_focus(false)), TerrainOutput::color) << "codes know no degrees";
    EXPECT_EQ(output_of(design, true, with_focus(true)), TerrainOutput::color_and_distance) << "blurred";
}

TEST(DrawnDesign, AirIsDrawnOnceAPixelWhereThePicturePassKnowsTheDistance) {
    design::DesignSettings design;
    design.terrain.style.sketch.contours = 1;
    EXPECT_FALSE(goes_off_screen(drawn_as(design, {}, false)));
    design.sky.air.is_shown = true;
    EXPECT_TRUE(has_air_in_picture(drawn_as(design, {}, false)));
    EXPECT_TRUE(goes_off_screen(drawn_as(design, {}, false)));
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, kWithoutDepth, false))) << "no depth off-screen";
    design.effects.shadows.in_air = 0.5;
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, {}, false))) << "alpha serves shafts of light alone";
    EXPECT_FALSE(goes_off_screen(drawn_as(design, {}, false)));
    design.terrain.style.sketch.silhouettes = 1;
    EXPECT_TRUE(has_air_in_picture(drawn_as(design, {}, false)));
    design.sky.air.is_shown = false;
    EXPECT_TRUE(goes_off_screen(drawn_as(design, {}, false)));
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, {}, false))) << "there is none";
}

TEST(DrawnDesign, RaysOfAStyleThatCodesCannotTellAreShadedFromAPictureOffScreen) {
    design::DesignSettings design;
    design.terrain.style.sketch.contours = 1;
    EXPECT_FALSE(drawn_as(design, kShades, false).is_deferred) << "it asks for triangles";
    design.terrain.renderer = design::TerrainRenderer::trace;
    EXPECT_TRUE(drawn_as(design, kShades, false).is_deferred);
    EXPECT_EQ(drawn_as(design, kShades, false).output, TerrainOutput::color_and_distance);
    design.terrain.renderer = design::TerrainRenderer::automatic;
    EXPECT_TRUE(drawn_as(design, kShades, false).is_deferred) << "rays may be chosen";
    design.terrain.renderer = design::TerrainRenderer::trace;
    EXPECT_FALSE(drawn_as(design, kWithoutDepth, false).is_deferred);
    EXPECT_FALSE(drawn_as(design, kEs2, false).is_deferred);
    EXPECT_EQ(drawn_as(design, kEs2, false).output, TerrainOutput::color) << "as triangles are drawn there";
    design.view.reference = design::Reference::flat;
    EXPECT_FALSE(drawn_as(design, kShades, false).is_deferred);
    design.view.reference = {};
    design.terrain.style.sketch.contours = 0;
    EXPECT_EQ(drawn_as(design, kShades, false).output, TerrainOutput::code);
    EXPECT_FALSE(drawn_as(design, kShades, false).is_deferred) << "codes have a picture of their own";
}

TEST(DrawAbility, RaysAreShadedWhereTheDeviceHasRoomForThem) {
    const effects::DeviceSettings shipped = test_support::shipped_device("es3-mid");
    EXPECT_TRUE(ability_of(shipped).shades_rays);
    EXPECT_TRUE(ability_of(test_support::shipped_device("desktop")).shades_rays);
    EXPECT_FALSE(ability_of(test_support::shipped_device("es2-small")).shades_rays);
    EXPECT_FALSE(ability_of(test_support::shipped_device("es2-small")).is_es3);
    effects::DeviceSettings device = shipped;
    device.budget.find(effects::kTracedPictures)->bytes = 4u * 1024 * 768;  // as files had it for codes
    EXPECT_FALSE(ability_of(device).shades_rays);
    device = shipped;
    device.max_chunk_slots = 1024;
    EXPECT_FALSE(ability_of(device).shades_rays);
    device = shipped;
    device.capability.gl.max_texture_units = 11;
    EXPECT_FALSE(ability_of(device).shades_rays);
    device = shipped;
    device.capability.depth24_targets = false;
    EXPECT_FALSE(ability_of(device).shades_rays);
}

TEST(DrawnDesign, ADesignWithoutALookOrRimOfItsFociHasNone) {
    design::DesignSettings design;
    scene::FocusRegions regions;
    ASSERT_TRUE(regions.try_push_back(scene::focus_region_at(0.8, 0.2)));
    test_support::ask_for(design, regions);
    EXPECT_TRUE(drawn_as(design, {}, true).has_focus);
    EXPECT_FALSE(drawn_as(design, {}, false).has_focus);
    design.foci[0].terrain = {};
    EXPECT_FALSE(drawn_as(design, {}, true).has_focus);
}

}  // namespace
}  // namespace tedavis::draw::test_drawn_design
