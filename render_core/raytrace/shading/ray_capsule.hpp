/// Intersects a ray with a capsule, a segment of a trajectory's tube: a cylinder between two points with hemispheres at its
/// ends.
///
/// All arithmetic is in double, in any frame with equal units along its axes. Quadratics are solved about the point of the ray
/// nearest to the axis, to keep precision for distant rays. A ray that begins inside the capsule hits it from inside. Ends may
/// coincide; the capsule is then a sphere. Pure; any thread; bounded.
#pragma once

#include <glm/vec3.hpp>

namespace tedavis::raytrace {

struct Capsule {
    glm::dvec3 from{0}, to{0};
    double radius = 1;  ///< above 0
};

struct CapsuleHit {
    bool is_hit = false;
    bool is_from_inside = false;
    double t = 0;
    glm::dvec3 normal{0, 0, 1};  ///< unit vector, outwards
    double along = 0;            ///< 0..1, position of the nearest point of the axis
};

/// Returns the first hit at `from_t` or later. The direction need not have unit length, but must not be zero.
[[nodiscard]] CapsuleHit ray_capsule(const glm::dvec3& origin, const glm::dvec3& direction, double from_t,
                                     const Capsule& capsule);

}  // namespace tedavis::raytrace
