/// The position of a hit in its cell, in the same bits for every tracer of this folder.
#pragma once

#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

struct HitPlace {
    float u = 0, v = 0;  ///< 0..1 towards higher columns and rows
};

/// Returns the position of a ray's hit; without a hit the result is meaningless. Pure; any thread.
[[nodiscard]] HitPlace hit_place(const Ray& ray, const Hit& hit);

}  // namespace tedavis::raytrace
