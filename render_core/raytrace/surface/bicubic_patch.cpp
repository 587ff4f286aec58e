#include "render_core/raytrace/surface/bicubic_patch.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

/// Exact at both ends, and never beyond them.
double cubic_between(double a, double b, double t) {
    const double z = (1 - t) * a + t * b;
    return std::clamp(z, std::min(a, b), std::max(a, b));
}

struct CurvePoint {
    double height, slope;
};

/// By de Casteljau's steps.
CurvePoint on_curve(const double c[4], double t) {
    const double a = cubic_between(c[0], c[1], t), b = cubic_between(c[1], c[2], t), d = cubic_between(c[2], c[3], t);
    const double left = cubic_between(a, b, t), right = cubic_between(b, d, t);
    return {cubic_between(left, right, t), 3 * (right - left)};
}

/// Six times the control heights of the curve from post[1] to post[2].
void bezier_of_posts(const double post[4], double control[4]) {
    control[0] = 6 * post[1];
    control[1] = 6 * post[1] + (post[2] - post[0]);
    control[2] = 6 * post[2] - (post[3] - post[1]);
    control[3] = 6 * post[2];
}

}  // namespace

SurfacePoint BicubicPatch::at(double u, double v) const {
    double heights[4], slopes_y[4];
    for (int i = 0; i < 4; ++i) {
        const double column[4] = {control[0][i], control[1][i], control[2][i], control[3][i]};
        const CurvePoint point = on_curve(column, v);
        heights[i] = point.height;
        slopes_y[i] = point.slope;
    }
    const CurvePoint along_u = on_curve(heights, u);
    return {along_u.height / kControlScale, along_u.slope / kControlScale, on_curve(slopes_y, u).height / kControlScale};
}

BicubicPatch bicubic_patch(const PatchPosts& posts) {
    BicubicPatch patch;
    double columns[4][4];  // [column of posts][along v]
    for (int i = 0; i < 4; ++i) {
        const double column[4] = {posts.z[0][i], posts.z[1][i], posts.z[2][i], posts.z[3][i]};
        bezier_of_posts(column, columns[i]);
    }
    for (int j = 0; j < 4; ++j) {
        const double row[4] = {columns[0][j], columns[1][j], columns[2][j], columns[3][j]};
        bezier_of_posts(row, patch.control[j]);
    }
    return patch;
}

}  // namespace tedavis::raytrace
