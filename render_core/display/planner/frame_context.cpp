#include "render_core/display/planner/frame_context.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::display {

namespace {

/// The position on the screen, for places ahead.
draw::MagnifiedSign magnified_sign(const terrain::View& view, const DistortionRecord& focus, double px_per_m) {
    constexpr double kSquareCorner = 1.42, kOctagonCorner = 1.09;
    const glm::dvec3 place = earth::to_ecef(focus.middle) - view.eye;
    const double scale = view.focal_px / glm::dot(place, view.forward);
    const double corner = focus.is_square ? kSquareCorner : kOctagonCorner;
    draw::MagnifiedSign sign;
    sign.middle = {static_cast<float>(0.5 * view.width + scale * glm::dot(place, view.right)),
                   static_cast<float>(0.5 * view.height + scale * glm::dot(place, view.down))};
    sign.radius_px = static_cast<float>(std::ldexp(corner * focus.radius_m, static_cast<int>(focus.power)) * px_per_m);
    sign.reach_px = static_cast<float>(focus.reach_m * px_per_m);
    sign.power = focus.power;
    sign.compression = focus.compression;
    return sign;
}

}  // namespace

FrameContext context_of(const PlannedFrame& frame, const Camera& camera) {
    FrameContext context{*frame.shown, frame.decisions, camera, frame};
    context.aircraft_msl_m = frame.altitude_msl_m;
    context.eye_msl_m = frame.eye_msl_m;
    context.map_share = frame.map_share;
    context.focus = frame.focus;
    context.shadows = frame.shadows;
    context.haze_per_m = frame.effects.runs(effects::Effect::haze) ? frame.picture.camera.haze_per_m : 0;
    context.is_free_view = frame.is_free_view;
    if (frame.draws_foci) context.foci = &frame.foci_plan.foci.regions;
    context.heights = frame.heights;
    context.alert_zone = frame.alert_zone;
    return context;
}

draw::HeightSpan height_span(const terrain::FileHeader& header) {
    return {double{header.min_height_m}, double{header.max_height_m}};
}

draw::MapInput make_map_input(const FrameContext& frame, const flight::AircraftState& state) {
    const design::ViewSettings& view = frame.design.view;
    draw::MapInput map;
    map.up_rad = draw::map_up_rad(state, frame.decisions);
    map.px_per_m = map_scale_px_per_m(view, frame.camera.view.width, frame.camera.view.height);
    map.is_flat = frame.decisions.show_terrain && frame.camera.view.is_flat();
    for (const DistortionRecord& focus : frame.record.distortion)
        if (focus.state == DistortionState::shown && frame.decisions.show_terrain)
            static_cast<void>(map.magnified.try_push_back(magnified_sign(frame.camera.view, focus, map.px_per_m)));
    if (view.mode != design::ViewMode::orthographic) return map;
    map.is_oblique = true;
    map.turn_rad = view.look_turn_rad;
    map.look_down_rad = view.look_down_rad;
    const flight::Signal source = flight::Signal::height_above_terrain;
    if (frame.camera.view.is_flat())
        map.above_ground_m = frame.aircraft_msl_m - frame.camera.view.flat_msl_m;
    else if (state.is_valid(source, frame.record.time))
        map.above_ground_m = state[source].value_or(0);
    return map;
}

}  // namespace tedavis::display
