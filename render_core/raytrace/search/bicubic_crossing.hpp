/// The first point at which a straight line meets a bicubic patch.
///
/// Over a line the patch is a polynomial of degree six. Its Bezier coefficients come from those of the part of the patch between
/// the ends of the line (blossoms: Ramshaw 1989), whose hull bounds them: where all are above zero the line passes. Else the
/// stretch is halved and the earlier half looked at first, down to 2^-40 of it. So no root is passed over that is wider than
/// that; where the line only touches, rounding decides, as it would in any arithmetic.
///
/// Cost: some 40 halvings where it meets, mostly none where it passes. Bounded: kMaxHalvings, beyond which (a line that lies in
/// the surface) it meets where it is.
#pragma once

#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

inline constexpr int kMaxHalvings = 2048;

/// The first place at which sign * (the line's height above the patch) is not above zero.
[[nodiscard]] Crossing bicubic_crossing(const BicubicPatch& patch, const CellRay& ray, double sign);

/// Seven Bezier coefficients of the line's height above the patch.
struct GapCurve {
    double c[7];
};
[[nodiscard]] GapCurve gap_curve(const BicubicPatch& patch, const CellRay& ray);

}  // namespace tedavis::raytrace
