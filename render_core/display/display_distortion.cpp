// What a frame of the display shows larger than it is.
#include <cmath>

#include "render_core/display/display.hpp"
#include "render_core/display/distortion.hpp"

namespace tedavis::display {
namespace {

/// Between the planes: what is moved along another plane than the own ship's gets higher or lower in its view.
void make_room(terrain::View& view) {
    double most_m = 0;
    for (const earth::Magnifier& magnifier : view.magnifiers) most_m = std::fmax(most_m, magnifier.farthest_move_m());
    view.near_m = std::fmax(view.near_m - most_m, 0.5 * view.near_m);
    view.far_m += most_m;
}

}  // namespace

void Display::magnify() {
    const design::FocusList& foci = settings_.design.foci;
    const scene::FocusRegions& regions = foci_.foci.regions;
    if (foci.empty()) return;
    const flight::OwnShipEstimate& own_ship = state_.own_ship;
    const auto& speed = state_[flight::Signal::ground_speed];
    const bool has_speed = state_.is_valid(flight::Signal::ground_speed, record_.time);
    DistortionScene scene{foci, {regions.data(), regions.size()}};
    scene.is_far = !free_view_active_ && is_map() && settings_.design.view.mode != design::ViewMode::perspective;
    scene.shows_terrain = decisions_.show_terrain;
    scene.has_position = own_ship.state == base::SignalState::valid;
    scene.own_ship = earth::to_ecef(own_ship.position);
    scene.ground_speed_mps = has_speed ? speed.value_or(kUnknownSpeed_mps) : std::nan("");
    DistortionPlan plan = plan_distortion(scene);
    for (DistortionRecord& record : plan.records) {
        if (record.state != DistortionState::shown) continue;
        const terrain::HeightAnswer ground = terrain_.true_height(record.middle.latitude_rad, record.middle.longitude_rad);
        const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
        const double msl_m = eye_.view.is_flat() ? eye_.view.flat_msl_m : ground.height.m;
        if (is_known) record.middle.height.m = msl_m + ground.undulation.m;
    }
    record_.distortion = plan.records;
    if (plan.magnifiers.empty()) return;
    eye_.view.magnifiers = plan.magnifiers;
    unmagnified_near_m_ = eye_.view.near_m;
    unmagnified_far_m_ = eye_.view.far_m;
    make_room(eye_.view);
    seen_ = seen_by_both(eye_.view, eyes_);
}

void Display::stop_magnifying() {
    eye_.view.magnifiers.clear();
    eye_.view.near_m = unmagnified_near_m_;
    eye_.view.far_m = unmagnified_far_m_;
    seen_ = seen_by_both(eye_.view, eyes_);
    withhold(record_.distortion, DistortionState::over_budget);
}

}  // namespace tedavis::display
