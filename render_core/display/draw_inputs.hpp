/// What the drawers of a frame are given, from what was planned of it. Pure; any thread.
#pragma once

#include "render_core/display/camera.hpp"
#include "render_core/display/frame_record.hpp"
#include "render_core/display/picture_layer.hpp"
#include "render_core/display/planned_frame.hpp"
#include "render_core/display/shadow_plan.hpp"
#include "render_core/draw/data/data_frame.hpp"
#include "render_core/draw/picture_pass.hpp"
#include "render_core/draw/sky_drawer.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/draw/terrain_drawer.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::display {

/// A planned frame. References to the display's own.
struct DrawContext {
    const design::DesignSettings& design;
    const policy::DisplayDecisions& decisions;
    const Camera& camera;
    const FrameStatement& record;
    double aircraft_msl_m = 0, eye_msl_m = 0;
    double haze_per_m = 0;                           ///< as planned; 0 for none
    double map_share = 0;                            ///< of the way from 3D to the map, 0..1
    bool is_free_view = false;                       ///< the eye is nobody's
    draw::HeightSpan heights{};                      ///< of the whole database
    draw::AirFrame air{};                            ///< as planned
    draw::FocusRange focus{};                        ///< as planned
    ShadowPlan shadows{};                            ///< as planned
    draw::ShadowRead shadow_read{};                  ///< as drawn
    draw::DistanceLeft terrain_left{}, data_left{};  ///< by what they draw
    const scene::FocusRegions* foci = nullptr;       ///< that change the ground; must stay. Null: none does
    bool blurs_context = false;                      ///< round them
    PictureLayer last = PictureLayer::symbology;     ///< nothing is drawn that lies before it
};

/// Of a planned frame, seen by one of its cameras.
[[nodiscard]] DrawContext context_of(const PlannedFrame& frame, const Camera& camera,
                                     PictureLayer last = PictureLayer::symbology);

[[nodiscard]] draw::HeightSpan height_span(const terrain::FileHeader& header);
[[nodiscard]] draw::TerrainDrawInput make_terrain_input(const DrawContext& frame);
[[nodiscard]] draw::SkyInput make_sky_input(const DrawContext& frame);
[[nodiscard]] draw::DataFrame make_data_frame(const DrawContext& frame);
/// Of the map and the orthographic view.
[[nodiscard]] draw::MapInput make_map_input(const DrawContext& frame, const flight::AircraftState& state);
/// Without what only the terrain knows: outlines, the part of the screen it is drawn in, and voids.
[[nodiscard]] draw::PictureInput make_picture_input(const DrawContext& frame);

}  // namespace tedavis::display
