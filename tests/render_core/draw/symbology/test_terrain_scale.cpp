#include "render_core/draw/symbology/terrain_scale.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_terrain_scale {
namespace {

LegendInput scene_legend() { return test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480).legend; }

TEST(TerrainScale, HasTheHeightsOfTheTerrainInTheUnitOfTheDesign) {
    LegendInput legend = scene_legend();
    legend.lowest = 100;
    legend.highest = 400;
    const TerrainScale feet = terrain_scale(legend);
    EXPECT_EQ(feet.low, 100);
    EXPECT_EQ(feet.high, 400);
    EXPECT_EQ(feet.unit, "FT");
    EXPECT_NEAR(feet.factor, 3.28084, 1e-5);
    legend.units = base::DisplayUnits::metric;
    EXPECT_EQ(terrain_scale(legend).unit, "M");
    EXPECT_EQ(terrain_scale(legend).factor, 1);
}

TEST(TerrainScale, IsThePalettesOwnWhereTheHeightsAreNotKnown) {
    LegendInput legend = scene_legend();
    legend.lowest = legend.highest = 0;
    EXPECT_EQ(terrain_scale(legend).low, legend.palette.stops[0].value);
    EXPECT_EQ(terrain_scale(legend).high, legend.palette.stops.back().value);
}

TEST(TerrainScale, OfSlopesIsInDegrees) {
    LegendInput legend = scene_legend();
    legend.palette.unit = design::PaletteUnit::degrees;
    EXPECT_EQ(terrain_scale(legend).unit, "DEG");
    EXPECT_NEAR(terrain_scale(legend).factor * base::radians(30), 30, 1e-9);
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_scale
