#include "render_core/draw/drawn_design.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/focus_grounds.hpp"

namespace tedavis::draw::test_drawn_design {
namespace {

GroundFocusKind with_focus(bool blurs) {
    GroundFocusKind focus;
    focus.foci = 1;
    focus.blurs = blurs;
    return focus;
}

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
    EXPECT_FALSE(goes_off_screen(drawn_as(design, true, false)));
    design.sky.air.is_shown = true;
    EXPECT_TRUE(has_air_in_picture(drawn_as(design, true, false)));
    EXPECT_TRUE(goes_off_screen(drawn_as(design, true, false)));
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, false, false))) << "no depth off-screen";
    design.effects.shadows.in_air = 0.5;
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, true, false))) << "alpha serves shafts of light alone";
    EXPECT_FALSE(goes_off_screen(drawn_as(design, true, false)));
    design.terrain.style.sketch.silhouettes = 1;
    EXPECT_TRUE(has_air_in_picture(drawn_as(design, true, false)));
    design.sky.air.is_shown = false;
    EXPECT_TRUE(goes_off_screen(drawn_as(design, true, false)));
    EXPECT_FALSE(has_air_in_picture(drawn_as(design, true, false))) << "there is none";
}

TEST(DrawnDesign, ADesignWithoutALookOrRimOfItsFociHasNone) {
    design::DesignSettings design;
    scene::FocusRegions regions;
    ASSERT_TRUE(regions.try_push_back(scene::focus_region_at(0.8, 0.2)));
    test_support::ask_for(design, regions);
    EXPECT_TRUE(drawn_as(design, true, true).has_focus);
    EXPECT_FALSE(drawn_as(design, true, false).has_focus);
    design.foci[0].terrain = {};
    EXPECT_FALSE(drawn_as(design, true, true).has_focus);
}

}  // namespace
}  // namespace tedavis::draw::test_drawn_design
