/// Finds the first hit of a ray with the surface of one cell, for every surface of surface/.
///
/// A hit is decided by the signs of the heights above the surface (patch and micro-structure) at both ends of the segment, then
/// by the search between; never by a discriminant alone. Ends on the side of a cell are equal bit for bit in its neighbour, so no
/// ray passes between cells.
///
/// | surface | between the ends | error of s |
/// |---|---|---|
/// | two triangles | linear in each | rounding |
/// | bilinear | the quadratic's earlier root, in the form without cancellation | rounding |
/// | bicubic | bicubic_crossing.hpp: first root of the sextic by subdivision of its Bezier form | 2^-40 |
/// | approximate bicubic | each small cell as bilinear | rounding |
/// | any with micro-structure | stepwise_crossing.hpp: steps that cannot pass the surface | see there |
///
/// A ray that begins on the surface hits it there. Pure; any thread; bounded.
#pragma once

#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

[[nodiscard]] Crossing first_crossing(const CellPatch& patch, const MicroStructure& micro, const CellRay& ray);

/// Returns the first root in [0, 1] of the quadratic with value g0 > 0 at 0, g1 at 1, and coefficient a of s^2.
[[nodiscard]] Crossing first_root(double g0, double g1, double a);

}  // namespace tedavis::raytrace
