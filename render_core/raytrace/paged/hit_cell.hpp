/// What shading needs of the cell that a ray hits, copied from paged ground, because the cell's chunk may no longer be in memory
/// when the hit is shaded. Plain data.
#pragma once

#include "render_core/raytrace/hit_place.hpp"

namespace tedavis::raytrace {

/// Undefined where the ray has no hit.
template <class Height>
struct HitCell {
    HitPlace place;
    /// Heights of the cell's posts, in the unit of the grid: (column, row), (column + 1, row), (column, row + 1),
    /// (column + 1, row + 1).
    Height corner[4];
};

}  // namespace tedavis::raytrace
