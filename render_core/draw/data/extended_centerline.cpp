#include "render_core/draw/data/extended_centerline.hpp"

#include <glm/geometric.hpp>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

glm::dvec3 on_ellipsoid(double latitude_rad, double longitude_rad) { return earth::to_ecef({latitude_rad, longitude_rad, {0}}); }

}  // namespace

Approach approach_of(const ElementInput& input, const ApproachFrame& frame) {
    if (!frame.has_own_ship) return {};
    const glm::dvec3 own = on_ellipsoid(frame.own_ship.latitude_rad, frame.own_ship.longitude_rad);
    const glm::dvec3 to =
        frame.has_destination ? on_ellipsoid(frame.destination_latitude_rad, frame.destination_longitude_rad) : own;
    Approach found;
    double least_m = kFarthestApproach_m;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const scene::Run run = input.layer.points_of(feature);
        if (run.count < 2) continue;
        const scene::ScenePoint middle =
            between(input.layer.points[run.first], input.layer.points[run.first + run.count - 1], 0.5);
        const glm::dvec3 at = on_ellipsoid(middle.latitude_rad, middle.longitude_rad);
        if (!frame.has_destination && !(glm::dot(at - own, frame.forward) > 0)) continue;
        const double distance_m = glm::distance(at, to);
        if (!(distance_m < least_m) || !(glm::distance(at, own) < kFarthestApproach_m)) continue;
        least_m = distance_m;
        found = {true, feature};
    }
    return found;
}

glm::dvec2 along_and_aside(const scene::ScenePoint& first, const scene::ScenePoint& last, const earth::Geodetic& place) {
    const glm::dvec2 way = flat_offset(first, last);
    scene::ScenePoint point = first;
    point.latitude_rad = place.latitude_rad;
    point.longitude_rad = place.longitude_rad;
    const glm::dvec2 offset = flat_offset(first, point);
    return {glm::dot(offset, way) / glm::length(way), glm::dot(offset, right_of(way))};
}

}  // namespace tedavis::draw
