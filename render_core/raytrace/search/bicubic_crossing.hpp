/// Finds the first point at which a straight line hits a bicubic patch.
///
/// Over a line the patch is a polynomial of degree six. Its Bezier coefficients come from those of the part of the patch
/// between the ends of the line (blossoms: Ramshaw 1989), whose hull bounds it: where all are above zero there is no hit. Else
/// the segment is halved and the earlier half is examined first, down to 2^-40 of its length. No pair of roots farther apart
/// than that is missed; where the line only touches the patch, rounding decides.
///
/// Cost: about 40 halvings with a hit, mostly none without. Bounded by kMaxHalvings; beyond it (a line in the surface) the
/// current point counts as the hit.
#pragma once

#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

inline constexpr int kMaxHalvings = 2048;

/// Returns the first point at which sign * (height of the line above the patch) is not above zero.
[[nodiscard]] Crossing bicubic_crossing(const BicubicPatch& patch, const CellRay& ray, double sign);

/// Seven Bezier coefficients of the line's height above the patch.
struct GapCurve {
    double c[7];
};
[[nodiscard]] GapCurve gap_curve(const BicubicPatch& patch, const CellRay& ray);

}  // namespace tedavis::raytrace
