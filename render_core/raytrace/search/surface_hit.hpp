/// The hit of a ray with a surface.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::raytrace {

struct SurfaceHit {
    HitSide side = HitSide::none;
    double t = std::numeric_limits<double>::infinity();
    CellPlace place;
    double height = 0;     ///< height of the surface, not of the ray
    glm::dvec2 slopes{0};  ///< along x and y
};

/// Counters of a trace.
struct TraceCounts {
    std::uint64_t nodes = 0, cells = 0;
};

}  // namespace tedavis::raytrace
