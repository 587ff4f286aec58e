#include "render_core/raytrace/shading/aperture_light.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

/// Between unit vectors; keeps the digits of small angles, which the arc cosine of their product does not.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2 * arc_tangent(glm::length(a - b) / std::max(glm::length(a + b), 1e-300));
}

}  // namespace

ApertureLight aperture_light(const Aperture& aperture, const glm::dvec3& normal, const glm::dvec3& towards_sun,
                             double sun_radius_rad, OverlapKind kind) {
    const double cosine = std::clamp(aperture.cos_radius, 0.0, 1.0);
    const double radius_rad = arc_cosine(cosine), distance_rad = angle_between(aperture.axis, towards_sun);
    ApertureLight light;
    // Of a cone the light on a surface that lies within it goes with the square of its sine, and the cosine of its axis.
    light.sky = std::clamp(glm::dot(normal, aperture.axis), 0.0, 1.0) * (1 - cosine * cosine);
    const double sun_area = cap_area(sun_radius_rad);
    if (sun_area > 0) {
        const double seen = kind == OverlapKind::exact ? cap_overlap(radius_rad, sun_radius_rad, distance_rad)
                                                       : smooth_cap_overlap(radius_rad, sun_radius_rad, distance_rad);
        light.sun = std::min(seen / sun_area, 1.0);
    } else {
        light.sun = distance_rad < radius_rad ? 1 : 0;
    }
    return light;
}

}  // namespace tedavis::raytrace
