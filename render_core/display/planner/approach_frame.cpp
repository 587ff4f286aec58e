#include "render_core/display/planner/approach_frame.hpp"

#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/data/planned_track.hpp"

namespace tedavis::display {
namespace {

constexpr double kFarthestPlan_m = 20'000;

void take_own_ship(const ElementFrame& frame, const flight::OwnShipEstimate& estimate, draw::ApproachFrame& approach) {
    approach.has_own_ship = true;
    approach.own_ship = estimate.position;
    if (!estimate.height_is_geometric)
        approach.own_ship.height.m += frame.ground.undulation_m(approach.own_ship.latitude_rad, approach.own_ship.longitude_rad);
}

void take_destination(const ElementFrame& frame, const scene::Scene& scene, draw::ApproachFrame& approach) {
    const draw::PlannedTrack way =
        draw::planned_track(scene, approach.own_ship, frame.time.utc.ns, frame.time.is_date, kFarthestPlan_m);
    if (way.layer == nullptr) return;
    const scene::ScenePoint& last = way.layer->points[way.run.first + way.run.count - 1];
    approach.has_destination = true;
    approach.destination_latitude_rad = last.latitude_rad;
    approach.destination_longitude_rad = last.longitude_rad;
}

}  // namespace

draw::ApproachFrame approach_frame(const ElementFrame& frame, const scene::Scene* scene) {
    draw::ApproachFrame approach;
    approach.forward = frame.view.forward;
    approach.metres_per_px_m = 1 / frame.view.focal_px;
    const flight::AircraftState* const aircraft = frame.own.aircraft;
    if (aircraft == nullptr || aircraft->own_ship.state != base::SignalState::valid) return approach;
    take_own_ship(frame, aircraft->own_ship, approach);
    if (scene != nullptr) take_destination(frame, *scene, approach);
    return approach;
}

}  // namespace tedavis::display
