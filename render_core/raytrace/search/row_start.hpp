/// **Inexact.** Starts a ray at the distance that the ray of the pixel below it passed without a hit.
///
/// In a picture of ground from above, what a pixel sees is mostly farther than what the pixel below it sees, so the rays of a
/// column go on where the last one ended (after Lee and Shin 1997, who prove it for vertical planes; here for any view, as a
/// heuristic).
///
/// What goes wrong: it holds where pixel and eye's vertical are in one plane. With roll, or away from the middle of the picture,
/// two rays go over different ground, and single high posts (needles, masts, ridges seen end on) between the eye and the start
/// are lost: 0.5 to 0.7 % of pixels over terrain with needles (PERF 1). It never holds where the picture shows the nadir, or
/// ground from below. Taking the nearest of several pixels below, and a share of the way, makes it rarer, never impossible.
#pragma once

#include <algorithm>
#include <cmath>

#include "render_core/base/span.hpp"
#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

struct RowStart {
    double share = 1;  ///< of the way below that is gone at once, 0..1; 0 is exact
};

/// The `t` at which a ray begins. `ways` are how far the rays of pixels below got over the ground, in posts; where one met
/// nothing it says nothing and is infinite, and where none met anything the ray begins where it would.
[[nodiscard]] inline float row_start(const Ray& ray, base::Span<const double> ways, const RowStart& settings) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double way : ways) nearest = std::min(nearest, way);
    const double speed = std::hypot(double{ray.direction.x}, double{ray.direction.y});
    if (!(nearest < std::numeric_limits<double>::infinity()) || !(speed > 0)) return ray.from;
    return std::clamp(static_cast<float>(settings.share * nearest / speed), ray.from, std::max(ray.from, ray.to));
}

/// How far a ray got over the ground, in posts.
[[nodiscard]] inline double distance_over_ground(const Ray& ray, double t) {
    return t * std::hypot(double{ray.direction.x}, double{ray.direction.y});
}

}  // namespace tedavis::raytrace
