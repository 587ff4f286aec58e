#include "render_core/raytrace/shading/cast_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::raytrace {

double lift_above(const SurfacePoint& point, const TracerPrecision& precision) {
    // Heights as they stand; the rise of the surface within a cell, with places of size 1 each way.
    const double sizes = std::abs(point.height) + 2 * (std::abs(point.slope_x) + std::abs(point.slope_y)) + 1;
    return precision.operations * precision.rounding * sizes;
}

Ray ray_from_surface(double x, double y, const SurfacePoint& point, const glm::dvec3& direction,
                     const TracerPrecision& precision) {
    Ray ray;
    ray.origin = {x, y, point.height + lift_above(point, precision)};
    // Of length 1 along the longer axis, so that no float of it is without digits.
    const double length = std::max({std::abs(direction.x), std::abs(direction.y), 1e-12 * std::abs(direction.z)});
    ray.direction = length > 0 ? glm::vec3(direction / length) : glm::vec3(0, 0, 1);
    return ray;
}

glm::dvec3 in_grid_space(const glm::dvec3& direction, const GridScale& scale) {
    return {direction.x / scale.column_m, direction.y / scale.row_m, direction.z / scale.height_m};
}

bool is_in_shadow(double x, double y, const SurfacePoint& point, const glm::dvec3& towards_light, const GridScale& scale,
                  const OcclusionTest& test, const TracerPrecision& precision) {
    if (glm::dot(normal_of(point, scale), towards_light) <= 0) return true;
    return test.is_occluded(test.context, ray_from_surface(x, y, point, in_grid_space(towards_light, scale), precision));
}

}  // namespace tedavis::raytrace
