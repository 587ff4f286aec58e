/// The point of a flat triangle that is nearest to the origin, also of a part of the triangle.
///
/// Pure functions of double; any frame and unit.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace tedavis::host_sim {

/// The points p with dot(normal, p) >= offset.
struct HalfSpace {
    glm::dvec3 normal{0, 0, 1};
    double offset = 0;
};
/// The intersection of half-spaces; without any, all of space.
using Region = std::vector<HalfSpace>;

/// Returns the place of the triangle that is nearest to the origin. A triangle without an area is a line or a point.
[[nodiscard]] glm::dvec3 nearest_to_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The same for the part of the triangle that lies in the region; nothing where there is none.
[[nodiscard]] std::optional<glm::dvec3> nearest_to_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                                          const Region& region);

}  // namespace tedavis::host_sim
