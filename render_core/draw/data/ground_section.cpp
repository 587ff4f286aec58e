#include "render_core/draw/data/ground_section.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kNoGround = -1e9;

glm::dvec2 metres_per_rad(double latitude_rad) {
    return {std::cos(latitude_rad) * earth::prime_vertical_radius_m(latitude_rad), earth::meridian_radius_m(latitude_rad)};
}

}  // namespace

glm::dvec2 flat_offset(const scene::ScenePoint& from, const scene::ScenePoint& to) {
    const glm::dvec2 metres = metres_per_rad(from.latitude_rad);
    return {std::remainder(to.longitude_rad - from.longitude_rad, 2 * base::kPi) * metres.x,
            (to.latitude_rad - from.latitude_rad) * metres.y};
}

scene::ScenePoint moved(const scene::ScenePoint& from, const glm::dvec2& by_m) {
    const glm::dvec2 metres = metres_per_rad(from.latitude_rad);
    scene::ScenePoint result = from;
    result.longitude_rad += by_m.x / metres.x;
    result.latitude_rad += by_m.y / metres.y;
    return result;
}

scene::ScenePoint between(const scene::ScenePoint& from, const scene::ScenePoint& to, double share) {
    scene::ScenePoint result = moved(from, flat_offset(from, to) * share);
    result.height_m = from.height_m + (to.height_m - from.height_m) * static_cast<float>(share);
    return result;
}

glm::dvec2 right_of(const glm::dvec2& way) {
    const double length = glm::length(way);
    return length > 0 ? glm::dvec2(way.y, -way.x) / length : glm::dvec2(0);
}

glm::dvec3 GroundSection::at(double share, double down_m) const {
    const scene::ScenePoint point = moved(middle, half * share);
    return earth::to_ecef({point.latitude_rad, point.longitude_rad, {height_m - down_m}});
}

/// Heights of points between which nothing is stated lie on a line.
GroundSection ground_section(const ElementInput& input, const scene::ScenePoint& middle, const glm::dvec2& half) {
    GroundSection result{middle, half};
    double highest = kNoGround;
    for (const double share : {-1.0, 0.0, 1.0}) {
        const scene::ScenePoint at = moved(middle, half * share);
        const double ground_m = input.ground.height_m(at.latitude_rad, at.longitude_rad);
        if (ground_m > highest) highest = ground_m;
    }
    const bool has_ground = highest > kNoGround;
    const Placed stated = placed(input, middle);
    result.is_known = has_ground || stated.is_known;
    result.height_m = (has_ground ? highest : stated.height_m) + kStripLift_m;
    return result;
}

SectionEnds section_ends(const GroundSection& at) {
    const glm::dvec3 left = at.at(-1), right = at.at(1), up = earth::up_at(left), out = glm::normalize(right - left);
    return {left, right, glm::normalize(up - out), glm::normalize(up + out)};
}

}  // namespace tedavis::draw
