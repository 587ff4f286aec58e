#include "render_core/display/draw_inputs.hpp"

namespace tedavis::display {
namespace {

constexpr design::Color kNothingKnown{0x24, 0x26, 0x2A};
/// Share of haze in unknown ground at the horizon, so that it is not mistaken for hazy water.
constexpr double kUnknownHaze = 0.6;
/// Not the usual blue and brown, since the own ship is below the surface.
constexpr design::Color kContactSky{0x3A, 0x3C, 0x42}, kContactGround{0x86, 0x0A, 0x0A}, kContactHorizon{0xC0, 0x18, 0x18};

}  // namespace

DrawContext draw_context_of(const PlannedFrame& frame, const Camera& camera, PictureLayer last) {
    DrawContext context{context_of(frame, camera)};
    context.last = last;
    return context;
}

draw::TerrainDrawInput make_terrain_input(const DrawContext& frame) {
    draw::TerrainDrawInput input;
    input.view = frame.camera.view;
    input.haze_per_m = frame.haze_per_m;
    const earth::Geodetic& place = frame.record.own_ship.position;
    const design::ShadeSettings& shade = frame.design.terrain.style.shade;
    for (std::size_t n = 0; n < shade.light_count; ++n)
        input.light_direction[n] = policy::towards_light(shade.lights[n].azimuth_rad, shade.lights[n].elevation_rad, place);
    input.light_direction[0] = policy::towards_light(frame.record.light.azimuth_rad, frame.record.light.elevation_rad, place);
    input.warning_colors = frame.decisions.show_warning_colors;
    input.aircraft_msl_m = frame.aircraft_msl_m;
    input.bands_lowered_m = frame.record.bands.lowered_m;
    input.alert = draw::alert_zone_look(frame.alert_zone);
    input.heights = frame.heights;
    input.air = frame.air;
    input.shadow = frame.shadow_read;
    input.left = frame.terrain_left;
    input.foci = frame.foci;
    input.blurs_context = frame.blurs_context;
    return input;
}

draw::SkyInput make_sky_input(const DrawContext& frame) {
    draw::SkyInput sky;
    sky.view = draw::make_view_frame(frame.camera.view);
    sky.colors = frame.design.sky;
    sky.air = frame.air;
    sky.axes = {frame.camera.view.forward, frame.camera.view.right, frame.camera.view.down};
    if (frame.decisions.show_terrain) {
        // Below the horizon, places without terrain are not known to be ground.
        sky.dip_rad = draw::horizon_dip_rad(frame.eye_msl_m);
        sky.ground_is_unknown = true;
        sky.colors.ground = frame.design.terrain.unknown;
        sky.colors.ground_horizon =
            design::blended(frame.design.terrain.unknown, frame.design.sky.haze, kUnknownHaze * (1 - frame.map_share));
    } else if (frame.decisions.plain_horizon && frame.decisions.below_terrain) {
        sky.colors.zenith = sky.colors.horizon = kContactSky;
        sky.colors.ground = kContactGround;
        sky.colors.ground_horizon = kContactHorizon;
    } else if (!frame.decisions.plain_horizon && !frame.is_free_view) {
        // Without attitude any horizon would be a wrong one.
        sky.colors.zenith = sky.colors.horizon = sky.colors.ground = sky.colors.ground_horizon = kNothingKnown;
    }
    return sky;
}

draw::DataFrame make_data_frame(const DrawContext& frame) {
    draw::DataFrame data;
    data.view = frame.camera.view;
    data.towards_light =
        policy::towards_light(frame.record.light.azimuth_rad, frame.record.light.elevation_rad, frame.record.own_ship.position);
    data.haze_per_m = frame.haze_per_m;
    data.haze = frame.design.sky.haze;
    data.air = frame.air;
    data.left = frame.data_left;
    return data;
}

draw::PictureInput make_picture_input(const DrawContext& frame) {
    const draw::TerrainDrawInput terrain = make_terrain_input(frame);
    constexpr float kAny_m = 1e9f;
    draw::PictureInput input;
    input.sky = make_sky_input(frame);
    input.heights = terrain.heights;
    if (terrain.warning_colors)
        input.bands = draw::bands_within(frame.design.warning_bands, terrain.aircraft_msl_m - terrain.bands_lowered_m,
                                         terrain.gear_down, -kAny_m, kAny_m);
    input.alert = terrain.alert.colors;
    input.haze_per_m = terrain.haze_per_m;
    input.left = frame.terrain_left;
    return input;
}

}  // namespace tedavis::display
