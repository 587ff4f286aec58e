/// A planned frame as one of its cameras sees it: the input for planning symbology and signs. Pure functions; any thread.
#pragma once

#include "render_core/display/planner/camera.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/display/planner/planned_frame.hpp"
#include "render_core/display/planner/shadow_plan.hpp"
#include "render_core/draw/focus_range.hpp"
#include "render_core/draw/height_span.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::display {

/// It refers to the planner's objects.
struct FrameContext {
    const design::DesignSettings& design;
    const policy::DisplayDecisions& decisions;
    const Camera& camera;
    const FrameStatement& record;
    double aircraft_msl_m = 0, eye_msl_m = 0;
    double haze_per_m = 0;       ///< 0 for none
    double map_share = 0;        ///< share of the transition from 3D to the map, 0..1
    bool is_free_view = false;   ///< the camera is not the own ship's
    draw::HeightSpan heights{};  ///< of the whole database
    draw::FocusRange focus{};
    ShadowPlan shadows{};
    policy::TerrainAlertZone alert_zone{};
    const scene::FocusRegions* foci = nullptr;  ///< foci that change the ground; null: none does
};

[[nodiscard]] FrameContext context_of(const PlannedFrame& frame, const Camera& camera);

[[nodiscard]] draw::HeightSpan height_span(const terrain::FileHeader& header);
/// Makes the input for the symbols of the map and of the orthographic view.
[[nodiscard]] draw::MapInput make_map_input(const FrameContext& frame, const flight::AircraftState& state);

}  // namespace tedavis::display
