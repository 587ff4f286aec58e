/// Cast shadows: whether the terrain hides the light from a point of the surface, by one ray to the light.
///
/// The ray must not hit its own surface because of rounding, and must not start so high that light leaks below neighbouring
/// terrain. So it starts on the surface itself (not at the hit of the view ray, whose rounding error grows with the distance) and
/// is lifted by a bound of the rounding errors of the tracer (Pharr, Jakob and Humphreys 2023, 6.8), not by a fixed length
/// (Dammertz and Keller 2006).
#pragma once

#include <glm/vec3.hpp>

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

/// Port: returns true where anything lies on a ray.
struct OcclusionTest {
    bool (*is_occluded)(const void* context, const Ray& ray) = nullptr;
    const void* context = nullptr;
};

/// The precision of the tracer.
struct TracerPrecision {
    double rounding = 0x1p-24;  ///< unit roundoff: 2^-24 for floats relative to the origin's cell, 2^-53 for doubles
    double operations = 16;     ///< number of roundings that may add up in a height
};

/// Returns how far above a surface point a ray must start, in height steps: a bound of the rounding of its height, and of its
/// position in the cell on its slope.
[[nodiscard]] double lift_above(const SurfacePoint& point, const TracerPrecision& precision);

/// Returns the ray from a surface point at (x, y) along a direction, both in grid space, to infinity.
[[nodiscard]] Ray ray_from_surface(double x, double y, const SurfacePoint& point, const glm::dvec3& direction,
                                   const TracerPrecision& precision);

/// Converts a direction in metres to grid space.
[[nodiscard]] glm::dvec3 in_grid_space(const glm::dvec3& direction, const GridScale& scale);

/// Returns true where the surface faces away from the light or terrain hides it. `towards_light` is in metres.
[[nodiscard]] bool is_in_shadow(double x, double y, const SurfacePoint& point, const glm::dvec3& towards_light,
                                const GridScale& scale, const OcclusionTest& test, const TracerPrecision& precision);

}  // namespace tedavis::raytrace
