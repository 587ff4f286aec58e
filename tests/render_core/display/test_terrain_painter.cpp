#include "render_core/display/terrain_painter.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/hills_display.hpp"
#include "tests/support/terrain/terrain_on_surface.hpp"

namespace tedavis::display::test_terrain_painter {
namespace {

TEST(TerrainPainter, DesignsOfOtherProgramsAreRefused) {
    test_support::MemoryBytes bytes(test_support::hills().image);
    const design::DesignSettings plain = design::default_design_settings();
    const test_support::TerrainOnSurface terrain("es3-mid", 64, 48, bytes, plain);
    design::DesignSettings other = plain;
    other.terrain.tau_px = 3;
    EXPECT_TRUE(terrain.painter().shows(draw::drawn_as(other, {}, false)));
    other.terrain.style.shade.technique = design::TerrainShade::phong;
    EXPECT_FALSE(terrain.painter().shows(draw::drawn_as(other, {}, false)));
}

TEST(TerrainPainter, BeforeItIsStartedItRefusesNothing) {
    const TerrainPainter painter{};
    const design::DesignSettings plain = design::default_design_settings();
    EXPECT_TRUE(painter.shows({&plain}));
    EXPECT_EQ(painter.tracer(), draw::TraceState::not_asked_for);
}

}  // namespace
}  // namespace tedavis::display::test_terrain_painter
