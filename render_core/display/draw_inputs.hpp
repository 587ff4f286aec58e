/// What the drawers of a frame are given, from what was planned of it. Pure; any thread.
#pragma once

#include "render_core/display/planner/frame_context.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "render_core/draw/drawers/data/data_frame.hpp"
#include "render_core/draw/drawers/picture_pass.hpp"
#include "render_core/draw/drawers/sky_drawer.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"

namespace tedavis::display {

/// What drawers read of a planned frame, and what has been decided while it is drawn.
struct DrawContext : FrameContext {
    draw::AirFrame air{};
    draw::ShadowRead shadow_read{};
    draw::DistanceLeft terrain_left{}, data_left{};  ///< by what they draw
    bool blurs_context = false;                      ///< round the foci
    PictureLayer last = PictureLayer::symbology;     ///< nothing is drawn that lies before it
};
[[nodiscard]] DrawContext draw_context_of(const PlannedFrame& frame, const Camera& camera,
                                          PictureLayer last = PictureLayer::symbology);

[[nodiscard]] draw::TerrainDrawInput make_terrain_input(const DrawContext& frame);
[[nodiscard]] draw::SkyInput make_sky_input(const DrawContext& frame);
[[nodiscard]] draw::DataFrame make_data_frame(const DrawContext& frame);
/// Without what only the terrain knows: outlines, the part of the screen it is drawn in, and voids.
[[nodiscard]] draw::PictureInput make_picture_input(const DrawContext& frame);

}  // namespace tedavis::display
