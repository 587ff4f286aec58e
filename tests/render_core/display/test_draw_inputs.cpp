#include "render_core/display/draw_inputs.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::display::test_draw_inputs {
namespace {

class DrawInputs : public ::testing::Test {
protected:
    DrawInputs() {
        record_.own_ship.position = {0.8, 0.2, {2000}};
        record_.light.azimuth_rad = base::radians(90);
        record_.light.elevation_rad = base::radians(30);
        decisions_.show_terrain = true;
        design_.sky.haze = {1, 2, 3};
        design_.terrain.unknown = {200, 0, 200};
    }
    [[nodiscard]] DrawContext frame() const {
        DrawContext context{design_, decisions_, camera_, record_};
        context.aircraft_msl_m = 1950;
        context.eye_msl_m = 1950;
        context.heights = {100, 900};
        return context;
    }

    design::DesignSettings design_;
    policy::DisplayDecisions decisions_;
    Camera camera_;
    FrameRecord record_;
};

TEST_F(DrawInputs, DataAreLitAndVeiledAsTheTerrainIs) {
    DrawContext hazy = frame();
    hazy.haze_per_m = 1e-4;
    const draw::TerrainDrawInput terrain = make_terrain_input(hazy);
    const draw::DataFrame data = make_data_frame(hazy);
    EXPECT_EQ(terrain.haze_per_m, 1e-4);
    EXPECT_EQ(make_terrain_input(frame()).haze_per_m, 0) << "as planned";
    EXPECT_LT(glm::distance(terrain.light_direction[0], data.towards_light), 1e-12);
    EXPECT_EQ(terrain.haze_per_m, data.haze_per_m);
    EXPECT_EQ(data.haze, design_.sky.haze);
    EXPECT_NEAR(glm::length(data.towards_light), 1, 1e-12);
}

TEST_F(DrawInputs, BandsAreThoseOfTheLoweredHeightOrNone) {
    EXPECT_EQ(make_picture_input(frame()).bands.count, 0u) << "not asked for";
    decisions_.show_warning_colors = true;
    design_.warning_bands.clear();
    ASSERT_TRUE(design_.warning_bands.try_push_back({}));
    EXPECT_EQ(make_picture_input(frame()).bands.count, 1u);
    record_.bands.lowered_m = 50;
    EXPECT_EQ(make_terrain_input(frame()).bands_lowered_m, 50);
    EXPECT_EQ(make_terrain_input(frame()).heights.highest_m, 900);
}

TEST_F(DrawInputs, TheZoneOfAnAlertIsColoredInEveryPicture) {
    EXPECT_FALSE(make_terrain_input(frame()).alert.is_shown());
    DrawContext alerted = frame();
    alerted.alert_zone.alert = policy::TerrainAhead::caution;
    alerted.alert_zone.north_mps = 60;
    alerted.alert_zone.until_s = 42;
    decisions_.show_warning_colors = false;  // bands may be off
    EXPECT_TRUE(make_terrain_input(alerted).alert.is_shown());
    EXPECT_EQ(make_terrain_input(alerted).alert.zone.until_s, 42);
    EXPECT_TRUE(make_picture_input(alerted).alert.is_shown);
    EXPECT_FALSE(make_picture_input(frame()).alert.is_shown);
}

TEST_F(DrawInputs, BelowTheHorizonIsWhatIsKnownThere) {
    const draw::SkyInput over_terrain = make_sky_input(frame());
    EXPECT_EQ(over_terrain.colors.ground, design_.terrain.unknown);
    EXPECT_GT(over_terrain.dip_rad, 0);
    decisions_.show_terrain = false;
    decisions_.plain_horizon = true;
    EXPECT_EQ(make_sky_input(frame()).colors.ground, design_.sky.ground);
    decisions_.plain_horizon = false;
    const draw::SkyInput unknown = make_sky_input(frame());
    EXPECT_EQ(unknown.colors.ground, unknown.colors.zenith) << "no horizon at all";
    DrawContext free = frame();
    free.is_free_view = true;
    EXPECT_EQ(make_sky_input(free).colors.zenith, design_.sky.zenith);
}

}  // namespace
}  // namespace tedavis::display::test_draw_inputs
