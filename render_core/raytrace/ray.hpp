/// Rays and what they meet, in grid space (height_grid.hpp).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

namespace tedavis::raytrace {

/// Points origin + t * direction, for t from `from` to `to`. The direction needs no length, but must not be zero. Of x and y,
/// what is nearer to zero than 1e-30 counts as 1e-30, whatever its sign: a machine that flushes denormals finds the same.
struct Ray {
    glm::dvec3 origin{0};
    glm::vec3 direction{0};
    float from = 0;
    float to = std::numeric_limits<float>::infinity();
};

enum class HitSide : std::uint8_t {
    none,   ///< nothing is met
    above,  ///< the surface, from above
    below,  ///< the surface, from below: the ray began there, or came there through the border or a cell without heights
};

struct Hit {
    HitSide side = HitSide::none;
    float t = std::numeric_limits<float>::infinity();
    std::uint32_t column = 0, row = 0;  ///< of the cell; only where something is met
};

}  // namespace tedavis::raytrace
