/// **Inexact.** Starts a ray at the distance over ground up to which the ray of the pixel below it had no hit.
///
/// In a picture of ground from above, the hit of a pixel is mostly farther than that of the pixel below it, so each ray of a
/// column starts where the one below ended (after Lee and Shin 1997, who prove it for vertical planes; here it is a heuristic for
/// any view).
///
/// What goes wrong: the assumption holds where the rays of both pixels lie in one vertical plane through the eye point. With
/// roll, or away from the middle of the picture, the two rays cross different ground, and narrow high ground (needles, masts,
/// ridges seen end on) between the eye point and the start is lost: for 0.5 to 0.7 % of pixels over terrain with needles. It
/// never holds where the picture shows the nadir, or ground from below. With the nearest of several pixels below, and a share of
/// the distance, errors are rarer, but not impossible.
#pragma once

#include <algorithm>
#include <cmath>

#include "render_core/base/span.hpp"
#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

struct RowStart {
    double share = 1;  ///< share of the distance of the ray below that is skipped, 0..1; 0 is exact
};

/// Returns the `t` at which a ray begins. `ways` are the distances over ground, in posts, to the hits of pixels below; infinite
/// for a pixel without a hit, which is ignored. Without any hit the ray begins at `ray.from`.
[[nodiscard]] inline float row_start(const Ray& ray, base::Span<const double> ways, const RowStart& settings) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double way : ways) nearest = std::min(nearest, way);
    const double speed = std::hypot(double{ray.direction.x}, double{ray.direction.y});
    if (!(nearest < std::numeric_limits<double>::infinity()) || !(speed > 0)) return ray.from;
    return std::clamp(static_cast<float>(settings.share * nearest / speed), ray.from, std::max(ray.from, ray.to));
}

/// Returns the horizontal distance of a ray's point at `t` from its origin, in posts.
[[nodiscard]] inline double distance_over_ground(const Ray& ray, double t) {
    return t * std::hypot(double{ray.direction.x}, double{ray.direction.y});
}

}  // namespace tedavis::raytrace
