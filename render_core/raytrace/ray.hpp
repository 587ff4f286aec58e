/// Rays and what they meet, in grid space (height_grid.hpp).
#pragma once

#include <cmath>
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
    float gap = 0;  ///< a point that is no more height steps below the surface than this, where there was none before, has met it
};

/// From an origin that is further away nothing is met in float's range.
inline constexpr double kFarthest = 1e9;

[[nodiscard]] inline bool is_in_reach(const glm::dvec3& origin) {
    return std::abs(origin.x) < kFarthest && std::abs(origin.y) < kFarthest && std::abs(origin.z) < kFarthest;
}

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
