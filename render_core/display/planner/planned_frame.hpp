/// All decisions about one frame, with the reasons that its record states; the planner passes them to the painter.
///
/// Plain data, with references to the planner's objects that are valid until the next plan. Thread  the display's.
#pragma once

#include "render_core/display/planner/camera.hpp"
#include "render_core/display/planner/caster_set.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/foci_plan.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/display/planner/shadow_plan.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/display/planner/stereo_cameras.hpp"
#include "render_core/display/planner/symbology_data.hpp"
#include "render_core/display/planner/terrain_planner.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/draw/focus_range.hpp"
#include "render_core/draw/height_span.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/effects/frame_budget.hpp"
#include "render_core/flight/flight_trail.hpp"
#include "render_core/policy/declutter.hpp"
#include "render_core/policy/failure_policy.hpp"
#include "render_core/policy/panel_lighting.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"

namespace tedavis::display {

/// The content of the picture of one camera: the frame's own, or one of a pair.
struct PlannedPicture {
    Camera camera;
    SeenTerrain terrain;
    PlannedElements data;
    CasterSet casters;
};

/// What is measured of a planned picture before the frame is shown.
enum class Probe : std::uint8_t {
    none,    ///< nothing: the picture is shown
    shown,   ///< the edges of the picture, which is shown if the next plan requests no other one
    hidden,  ///< the edges of the picture, which is not shown
};

/// What the painter found of a planned picture: plain input of FramePlanner::plan_again().
struct PainterFindings {
    bool terrain_failed = false;  ///< it could not be drawn; then nothing was measured
    effects::ClutterMap edges;    ///< of the picture that PlannedClutter::probe requests
};

struct PlannedSaliency {
    bool is_shown = false;
    bool is_measured = false;  ///< of this picture; else the map is an earlier frame's
};

/// How the clutter budget is held: the measurement that the frame uses, and what is reduced in it.
struct PlannedClutter {
    Probe probe = Probe::none;
    bool has_terrain = false;         ///< an earlier probe of the frame has drawn the same terrain
    policy::Declutter before_probes;  ///< of the frame, while its probes are planned
    effects::ClutterMeasures measured;
    effects::ClutterMap reached;
    std::uint32_t roles = 0;  ///< of layers that are reduced; a bit for each scene::LayerRole
};

struct PlannedFrame : FrameStatement {
    flight::AircraftState state;
    const flight::FlightTrail* trail = nullptr;  ///< null where none is kept
    policy::DisplayConditions conditions;
    policy::DisplayDecisions decisions;
    design::AspectWeights weights;

    const design::DesignSettings* shown = nullptr;  ///< the design that is shown, at these weights
    std::uint64_t look_key = 0;                     ///< changes when painters must take the design again
    bool draws_foci = false;                        ///< the ground is drawn with what foci change of it

    PlannedPicture picture;
    terrain::View seen;  ///< all that is drawn of the frame: the camera's view, or as wide as a picture for each eye
    StereoCameras stereo_cameras;
    double eye_msl_m = 0;
    double map_share = 0;       ///< share of the transition from 3D to the map, 0..1
    bool is_free_view = false;  ///< the camera is not the own ship's
    bool terrain_has_void = false;
    draw::HeightSpan heights;  ///< of the whole database

    FociPlan foci_plan;
    policy::Declutter declutter;
    PlannedClutter clutter;
    PlannedSaliency saliency;
    SpatialDataPlan data;
    std::uint64_t ground_key = 0;                    ///< changes with `ground_slice`
    const scene::GridSlice* ground_slice = nullptr;  ///< what colours the ground; null for nothing
    MapsBeside maps_beside;

    ShadowPlan shadows;
    draw::FocusRange focus;
    policy::PanelLight panel;
    effects::FramePlan effects;
    effects::FrameCounters counters;
    effects::BudgetReport budget;
    bool keeps_scene = false;  ///< the picture is kept for the frames that follow, which another design shows
};

}  // namespace tedavis::display
