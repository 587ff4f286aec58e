// The camera of a frame, and what it magnifies.
#include <cmath>

#include "render_core/display/planner/distortion.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/planner/symbology_plan.hpp"
#include "render_core/display/planner/terrain_ground.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {

using flight::Signal;

namespace {

/// Between the planes: what is moved along another plane than the own ship's gets higher or lower in its view.
void make_room(terrain::View& view) {
    double most_m = 0;
    for (const earth::Magnifier& magnifier : view.magnifiers) most_m = std::fmax(most_m, magnifier.farthest_move_m());
    view.near_m = std::fmax(view.near_m - most_m, 0.5 * view.near_m);
    view.far_m += most_m;
}

}  // namespace

void FramePlanner::plan_view() {
    const earth::Geodetic& place = frame_->state.own_ship.position;
    const double undulation = undulation_m(place);
    frame_->altitude_msl_m = place.height.m - (frame_->state.own_ship.height_is_geometric ? undulation : 0);
    CameraInput input;
    input.own_ship = {place.latitude_rad, place.longitude_rad, {frame_->altitude_msl_m + undulation}};
    input.msl_m = frame_->altitude_msl_m;
    input.above_ground_m = frame_->state[Signal::height_above_terrain].value_or(frame_->altitude_msl_m);
    input.heading_rad = frame_->heading_rad;
    input.pitch_rad = frame_->pitch_rad;
    input.roll_rad = frame_->roll_rad;
    const design::EyePoint& eye = settings_.aircraft.eye;
    input.eye_m = {eye.forward_m, eye.right_m, -eye.up_m};
    input.map_up_rad = draw::map_up_rad(frame_->state, frame_->decisions);
    input.map_share = free_view_active_ ? 0 : memory_->view.map_share();
    input.width_px = settings_.width_px;
    input.height_px = settings_.height_px;
    frame_->map_share = memory_->view.map_share();
    frame_->is_free_view = free_view_active_;
    if (terrain_.is_started()) frame_->heights = height_span(terrain_.database().header());
    frame_->picture.camera = make_camera(input, look_.view, look_.sky.haze_distance_m);
    if (free_view_active_) frame_->picture.camera.view = free_view_;
    if (look_.view.reference == design::Reference::flat) frame_->picture.camera.view.flat_msl_m = look_.view.flat_msl_m;
    const earth::Geodetic eye_place = earth::from_ecef(frame_->picture.camera.view.eye);
    frame_->eye_msl_m = eye_place.height.m - undulation_m(eye_place);
    frame_->stereo_cameras = {};
    if (painter_.is_stereo && is_near())
        frame_->stereo_cameras = stereo_cameras(look_.effects.stereo, frame_->picture.camera.view.focal_px,
                                                frame_->picture.camera.view.near_m, painter_.stereo_margin_px);
    frame_->seen = seen_by_both(frame_->picture.camera.view, frame_->stereo_cameras);
}

/// Where they are, whatever is shown of them.
void FramePlanner::plan_foci() {
    frame_->foci_plan = {};
    if (look_.foci.empty() || !terrain_.is_started()) return;
    const design::PrioritySettings& priority = look_.priority;
    TerrainGround ground(terrain_, frame_->picture.camera.view);
    const double own_height_m = frame_->altitude_msl_m + undulation_m(frame_->state.own_ship.position);
    frame_->foci_plan =
        display::plan_foci(look_.foci, {frame_->state.own_ship, own_height_m, data_.has_scene() ? &data_.scene() : nullptr,
                                        frame_->flight_time, ground, priority.is_stated ? memory_->boost.hazard() : nullptr});
}

void FramePlanner::magnify() {
    const design::FocusList& foci = look_.foci;
    const scene::FocusRegions& regions = frame_->foci_plan.foci.regions;
    if (foci.empty()) return;
    const flight::OwnShipEstimate& own_ship = frame_->state.own_ship;
    const auto& speed = frame_->state[flight::Signal::ground_speed];
    const bool has_speed = frame_->state.is_valid(flight::Signal::ground_speed, frame_->time);
    DistortionScene scene{foci, {regions.data(), regions.size()}};
    scene.is_far = !free_view_active_ && is_map() && look_.view.mode != design::ViewMode::perspective;
    scene.shows_terrain = frame_->decisions.show_terrain;
    scene.has_position = own_ship.state == base::SignalState::valid;
    scene.own_ship = earth::to_ecef(own_ship.position);
    scene.ground_speed_mps = has_speed ? speed.value_or(kUnknownSpeed_mps) : std::nan("");
    DistortionPlan plan = plan_distortion(scene);
    for (DistortionRecord& record : plan.records) {
        if (record.state != DistortionState::shown) continue;
        const terrain::HeightAnswer ground = terrain_.true_height(record.middle.latitude_rad, record.middle.longitude_rad);
        const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
        const double msl_m = frame_->picture.camera.view.is_flat() ? frame_->picture.camera.view.flat_msl_m : ground.height.m;
        if (is_known) record.middle.height.m = msl_m + ground.undulation.m;
    }
    frame_->distortion = plan.records;
    if (plan.magnifiers.empty()) return;
    frame_->picture.camera.view.magnifiers = plan.magnifiers;
    unmagnified_near_m_ = frame_->picture.camera.view.near_m;
    unmagnified_far_m_ = frame_->picture.camera.view.far_m;
    make_room(frame_->picture.camera.view);
    frame_->seen = seen_by_both(frame_->picture.camera.view, frame_->stereo_cameras);
}

void FramePlanner::stop_magnifying() {
    frame_->picture.camera.view.magnifiers.clear();
    frame_->picture.camera.view.near_m = unmagnified_near_m_;
    frame_->picture.camera.view.far_m = unmagnified_far_m_;
    frame_->seen = seen_by_both(frame_->picture.camera.view, frame_->stereo_cameras);
    withhold(frame_->distortion, DistortionState::over_budget);
}

}  // namespace tedavis::display
