/// The surface of one cell as a bicubic patch through its posts (Catmull and Rom 1974: slope at a post is half the difference of
/// its neighbours), in Bezier form: 4 x 4 control heights whose hull holds the patch (Farin, Curves and Surfaces for CAGD, 4).
///
/// The patch overshoots its posts by up to 28.125 % of the range of the sixteen, so the maximum of the cell's four posts is not a
/// bound. The surface is defined by what at() returns: every interpolation is clamped between its two heights, so that rounding
/// cannot leave the hull, and bounds hold bit for bit.
///
/// u and v, 0..1, run from the cell's first post along its row and its column. Edges of neighbouring cells are equal, bit for
/// bit.
#pragma once

#include "render_core/raytrace/surface/patch_posts.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

struct BicubicPatch {
    double control[4][4] = {};  ///< 36 times the control heights, [along v][along u]; integers where posts are std::int16_t

    [[nodiscard]] SurfacePoint at(double u, double v) const;
};

/// Makes the patch of a cell that has a surface.
[[nodiscard]] BicubicPatch bicubic_patch(const PatchPosts& posts);

/// Control values are stored multiplied by 36, so that the two divisions by 6 of the form give integers.
inline constexpr double kControlScale = 36;

}  // namespace tedavis::raytrace
