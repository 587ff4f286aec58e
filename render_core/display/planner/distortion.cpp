#include "render_core/display/planner/distortion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::display {
namespace {

bool is_clear_of(const earth::Magnifier& magnifier, const DistortionScene& scene) {
    const double speed = std::isfinite(scene.ground_speed_mps) ? scene.ground_speed_mps : kUnknownSpeed_mps;
    return !magnifier.reaches(scene.own_ship, std::fmax(kMinClear_m, kClear_s * speed));
}

earth::Geodetic middle_of(const scene::FocusRegion& region) {
    return earth::from_ecef(region.anchor + region.east * region.points[0].x + region.north * region.points[0].y);
}

DistortionState state_of(const DistortionScene& scene, const scene::FocusRegion& region) {
    if (!scene.is_far) return DistortionState::egocentric;
    if (!scene.shows_terrain) return DistortionState::no_terrain;
    if (!region.is_valid || region.point_count == 0) return DistortionState::no_place;
    return region.point_count > 1 ? DistortionState::not_one : DistortionState::shown;
}

/// Adds the focus to the plan unless there is a reason against it.
DistortionState magnify(const DistortionScene& scene, const scene::FocusRegion& region, DistortionRecord& record,
                        earth::Magnifiers& magnifiers) {
    const earth::Geodetic middle = middle_of(region);
    record.middle = middle;
    record.is_square = region.is_square;
    record.radius_m = region.radius_m;
    earth::Magnifier magnifier;
    if (!earth::Magnifier::make(
            {middle.latitude_rad, middle.longitude_rad, region.is_square, region.radius_m, region.context.width_m, record.power},
            magnifier))
        return DistortionState::too_narrow;
    if (!scene.has_position) return DistortionState::no_position;
    if (!is_clear_of(magnifier, scene)) return DistortionState::own_ship;
    if (!magnifiers.add(magnifier)) return DistortionState::overlaps;
    record.compression = magnifier.compression();
    record.reach_m = magnifier.reach_m();
    return DistortionState::shown;
}

}  // namespace

const char* reason_of(DistortionState state) noexcept {
    switch (state) {
        case DistortionState::shown: return "";
        case DistortionState::egocentric: return "what the own ship sees must lie where it is";
        case DistortionState::no_terrain: return "the terrain is not shown";
        case DistortionState::no_place: return "the focus is nowhere";
        case DistortionState::not_one: return "the focus is not one place";
        case DistortionState::too_narrow: return "its context leaves too little room";
        case DistortionState::no_position: return "the own ship's position is not known";
        case DistortionState::own_ship: return "the own ship, or half a minute of its way, is too near";
        case DistortionState::overlaps: return "it would reach into another one";
        case DistortionState::over_budget: return "the device has not the triangles for it";
    }
    return "unknown";
}

DistortionPlan plan_distortion(const DistortionScene& scene) noexcept {
    DistortionPlan plan;
    for (std::size_t n = 0; n < scene.foci.size(); ++n) {
        const design::FocusSettings& focus = scene.foci[n];
        if (focus.power == 0) continue;
        DistortionRecord record;
        record.focus = focus.name;
        record.power = focus.power;
        const scene::FocusRegion region = n < scene.regions.size() ? scene.regions[n] : scene::FocusRegion{};
        record.state = state_of(scene, region);
        if (record.state == DistortionState::shown) record.state = magnify(scene, region, record, plan.magnifiers);
        static_cast<void>(plan.records.try_push_back(record));
    }
    return plan;
}

void withhold(DistortionRecords& records, DistortionState reason) noexcept {
    for (DistortionRecord& record : records) {
        if (record.state != DistortionState::shown) continue;
        record.state = reason;
        record.compression = 0;
        record.reach_m = 0;
    }
}

}  // namespace tedavis::display
