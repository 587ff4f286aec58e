#include "render_core/display/planner/display_settings.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tedavis::display::test_display_settings {
namespace {

constexpr flight::FlightPhase kCruise{flight::Scenario::cruise, 0};

TEST(DisplaySettings, AnyDesignMayAskForRays) {
    design::DesignSettings triangles, rays;
    triangles.terrain.renderer = design::TerrainRenderer::raster;
    rays.terrain.renderer = design::TerrainRenderer::trace;
    DisplaySettings settings;
    settings.design = triangles;
    EXPECT_FALSE(settings.asks_for_rays());
    const auto phases = std::make_unique<design::PhaseDesigns>();
    settings.phases = phases.get();
    ASSERT_TRUE(phases->add({kCruise, "flat"}, triangles));
    EXPECT_FALSE(settings.asks_for_rays());
    ASSERT_TRUE(phases->add({flight::kTakeoffStart, "traced"}, rays));
    EXPECT_TRUE(settings.asks_for_rays());
    settings.phases = nullptr;
    settings.design = rays;
    EXPECT_TRUE(settings.asks_for_rays());
    settings.design.terrain.renderer = design::TerrainRenderer::automatic;
    EXPECT_TRUE(settings.asks_for_rays()) << "rays may be chosen";
}

}  // namespace
}  // namespace tedavis::display::test_display_settings
