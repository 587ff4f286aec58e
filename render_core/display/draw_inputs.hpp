/// Makes the inputs of a frame's drawers from the planned frame. Pure functions; any thread.
#pragma once

#include "render_core/display/planner/frame_context.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "render_core/draw/drawers/data/data_frame.hpp"
#include "render_core/draw/drawers/picture_pass.hpp"
#include "render_core/draw/drawers/sky_drawer.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"

namespace tedavis::display {

/// The parts of a planned frame that drawers read, and the state of its drawing.
struct DrawContext : FrameContext {
    draw::AirFrame air{};
    draw::ShadowRead shadow_read{};
    draw::DistanceLeft terrain_left{}, data_left{};  ///< distances that the terrain and the data write
    bool blurs_context = false;                      ///< the picture is blurred round the foci
    PictureLayer last = PictureLayer::symbology;     ///< the last layer that is drawn
};
[[nodiscard]] DrawContext draw_context_of(const PlannedFrame& frame, const Camera& camera,
                                          PictureLayer last = PictureLayer::symbology);

[[nodiscard]] draw::TerrainDrawInput make_terrain_input(const DrawContext& frame);
[[nodiscard]] draw::SkyInput make_sky_input(const DrawContext& frame);
[[nodiscard]] draw::DataFrame make_data_frame(const DrawContext& frame);
/// The caller adds what depends on the terrain: outlines, the part of the screen in which it is drawn, and voids.
[[nodiscard]] draw::PictureInput make_picture_input(const DrawContext& frame);

}  // namespace tedavis::display
