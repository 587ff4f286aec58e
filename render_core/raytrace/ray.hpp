/// Rays and their hits, in grid space (height_grid.hpp).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

namespace tedavis::raytrace {

/// The points origin + t * direction, for t from `from` to `to`. The direction need not have unit length, but must not be zero.
/// Its x or y nearer to zero than 1e-30 counts as 1e-30, whatever the sign, so that machines that flush denormals give the same
/// result.
struct Ray {
    glm::dvec3 origin{0};
    glm::vec3 direction{0};
    float from = 0;
    float to = std::numeric_limits<float>::infinity();
    float gap = 0;  ///< a ray that begins below the surface by up to this many height steps hits it there
};

/// Rays from an origin that is farther away have no hits.
inline constexpr double kFarthest = 1e9;

[[nodiscard]] inline bool is_in_reach(const glm::dvec3& origin) {
    return std::abs(origin.x) < kFarthest && std::abs(origin.y) < kFarthest && std::abs(origin.z) < kFarthest;
}

enum class HitSide : std::uint8_t {
    none,   ///< no hit
    above,  ///< the surface is hit from above
    below,  ///< the surface is hit from below: the ray began there, or entered through the border or a cell without heights
};

struct Hit {
    HitSide side = HitSide::none;
    float t = std::numeric_limits<float>::infinity();
    std::uint32_t column = 0, row = 0;  ///< cell of the hit; only valid with a hit
};

}  // namespace tedavis::raytrace
