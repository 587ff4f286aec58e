#include "render_core/draw/data/billboard_place.hpp"

#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/ground_section.hpp"
#include "render_core/scene/area_limits.hpp"

namespace tedavis::draw {
namespace {

/// Middle of an area's corners, in the plane of the first one.
scene::ScenePoint middle_of(const ElementInput& input, const scene::Run& run) {
    scene::ScenePoint middle = input.layer.points[run.first];
    double north = 0, east = 0;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const scene::ScenePoint& point = input.layer.points[run.first + n];
        north += (point.latitude_rad - middle.latitude_rad) / run.count;
        east += std::remainder(point.longitude_rad - middle.longitude_rad, 2 * base::kPi) / run.count;
    }
    middle.latitude_rad += north;
    middle.longitude_rad += east;
    middle.height_m = std::numeric_limits<float>::quiet_NaN();
    return middle;
}

/// Between the thresholds, on the ground.
scene::ScenePoint middle_of_runway(const ElementInput& input, const scene::Run& run) {
    scene::ScenePoint middle = between(input.layer.points[run.first], input.layer.points[run.first + run.count - 1], 0.5);
    middle.height_m = std::numeric_limits<float>::quiet_NaN();
    return middle;
}

scene::ScenePoint gone(scene::ScenePoint point, const glm::dvec2& drift_m) {
    const double across = std::cos(point.latitude_rad) * earth::prime_vertical_radius_m(point.latitude_rad);
    if (across > 0) point.longitude_rad += drift_m.x / across;
    point.latitude_rad += drift_m.y / earth::meridian_radius_m(point.latitude_rad);
    return point;
}

}  // namespace

bool anchor_of(const ElementInput& input, std::uint32_t feature, scene::ScenePoint& anchor) {
    const scene::LayerShape shape = input.layer.entry->shape;
    if (shape == scene::LayerShape::points || shape == scene::LayerShape::meshes) {
        anchor = input.layer.points[feature];
        return true;
    }
    const scene::Run run = input.layer.points_of(feature);
    if (run.count == 0) return false;
    if (input.layer.entry->role == scene::LayerRole::runway && shape == scene::LayerShape::lines) {
        anchor = middle_of_runway(input, run);
        return true;
    }
    anchor = shape == scene::LayerShape::areas
                 ? gone(middle_of(input, run), scene::drift_m(input.layer, feature, input.time_ns, input.has_date))
                 : input.layer.points[run.first + run.count / 2];
    return true;
}

bool has_limits(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::no_go || layer.entry->role == scene::LayerRole::airspace;
}

std::uint8_t sign_stems(const scene::Layer& layer) { return layer.entry->role == scene::LayerRole::obstacle ? 1 : kSignStems; }

Placed place_of(const ElementInput& input, std::uint32_t feature, const scene::ScenePoint& anchor) {
    if (!has_limits(input.layer)) return placed(input, anchor);
    const scene::HeightLimit ceiling = scene::area_limits(input.layer, feature).ceiling;
    if (ceiling.datum == scene::HeightDatum::ground && std::isfinite(ceiling.m))
        return placed_over_ground(input, anchor.latitude_rad, anchor.longitude_rad, ceiling.m);
    return placed(input, anchor.latitude_rad, anchor.longitude_rad, ceiling.m);
}

}  // namespace tedavis::draw
