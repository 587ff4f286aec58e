/// The surface of one cell as a bicubic patch through its posts (Catmull and Rom 1974: slope at a post is half the difference of
/// its neighbours), in Bezier form: 4 x 4 control heights whose hull holds the patch (Farin, Curves and Surfaces for CAGD, 4).
///
/// The patch overshoots its posts: by up to 28.125 % of the range of the sixteen (NUMERICS finding 4), so that the maximum of the
/// cell's four posts bounds nothing. Here the surface *is* what `at` returns: every step is kept between the two heights it goes
/// between, so that rounding cannot leave the hull either, and bounds hold bit for bit.
///
/// u and v, 0..1, go from the cell's first post along its row and its column. Edges of neighbouring cells are equal, bit for bit.
#pragma once

#include "render_core/raytrace/surface/patch_posts.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

struct BicubicPatch {
    double control[4][4] = {};  ///< 36 times the control heights, [along v][along u]; integers where posts are std::int16_t

    [[nodiscard]] SurfacePoint at(double u, double v) const;
};

/// Of a cell that has a surface.
[[nodiscard]] BicubicPatch bicubic_patch(const PatchPosts& posts);

/// Control values are kept 36 times as large: the two divisions by 6 of the form then leave integers.
inline constexpr double kControlScale = 36;

}  // namespace tedavis::raytrace
