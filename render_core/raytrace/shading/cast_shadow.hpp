/// Whether a point of the surface is in the shadow of the terrain: one more ray, from the point to the light.
///
/// The ray must not meet the surface that it starts from because rounding put its start below it, and must not start so high that
/// light leaks under what stands next to it. So it starts on the surface itself (not where the eye's ray was when it met it,
/// which is off by that ray's rounding, more with the distance) and is lifted by a bound of the rounding errors of the tracer
/// that follows it (Pharr, Jakob and Humphreys 2023, 6.8), not by a fixed length (Dammertz and Keller 2006; NUMERICS A22).
#pragma once

#include <glm/vec3.hpp>

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

/// Asks whoever traces: true where anything lies on a ray.
struct OcclusionTest {
    bool (*is_occluded)(const void* context, const Ray& ray) = nullptr;
    const void* context = nullptr;
};

/// How precise the tracer is that follows the ray.
struct TracerPrecision {
    double rounding = 0x1p-24;  ///< of its numbers: 2^-24 for floats relative to the origin's cell, 2^-53 for doubles
    double operations = 16;     ///< how many roundings may add up in a height
};

/// How far above a surface point a ray must start, in height steps: roundings of heights of this size, and of places within a
/// cell on a slope of this steepness.
[[nodiscard]] double lift_above(const SurfacePoint& point, const TracerPrecision& precision);

/// From a surface point at (x, y) of grid space along a direction of grid space, to infinity.
[[nodiscard]] Ray ray_from_surface(double x, double y, const SurfacePoint& point, const glm::dvec3& direction,
                                   const TracerPrecision& precision);

/// A direction in metres as one of grid space.
[[nodiscard]] glm::dvec3 in_grid_space(const glm::dvec3& direction, const GridScale& scale);

/// True where the surface faces away from the light, or something hides it. `towards_light` in metres.
[[nodiscard]] bool is_in_shadow(double x, double y, const SurfacePoint& point, const glm::dvec3& towards_light,
                                const GridScale& scale, const OcclusionTest& test, const TracerPrecision& precision);

}  // namespace tedavis::raytrace
