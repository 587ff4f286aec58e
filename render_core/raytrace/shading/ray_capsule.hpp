/// Where a ray meets a capsule, a stretch of a trajectory's tube: a round bar between two points with half balls at its ends.
///
/// All in double, in any frame with equal units along its axes. Quadratics are solved about the point of the ray nearest to the
/// axis, so that far rays keep their digits. A ray that begins within the capsule meets its inside. Ends may coincide: then it is
/// a ball. Pure; any thread; bounded.
#pragma once

#include <glm/vec3.hpp>

namespace tedavis::raytrace {

struct Capsule {
    glm::dvec3 from{0}, to{0};
    double radius = 1;  ///< above 0
};

struct CapsuleHit {
    bool is_met = false;
    bool is_from_inside = false;
    double t = 0;
    glm::dvec3 normal{0, 0, 1};  ///< unit vector, outwards
    double along = 0;            ///< 0..1, of the point of the axis that is nearest
};

/// The first point at `from_t` or later. The direction needs no length, but must not be zero.
[[nodiscard]] CapsuleHit ray_capsule(const glm::dvec3& origin, const glm::dvec3& direction, double from_t,
                                     const Capsule& capsule);

}  // namespace tedavis::raytrace
