#include "render_core/raytrace/search/stepwise_crossing.hpp"

#include <cmath>

namespace tedavis::raytrace {
namespace {

struct SteepestSlopes {
    double x = 0, y = 0;
};

SteepestSlopes steepest_of_patch(const CellPatch& patch) {
    SteepestSlopes most;
    if (!is_cubic(patch.kind)) {
        for (int n = 0; n < 2; ++n) {
            most.x = std::max(most.x, std::abs(patch.corner[n][1] - patch.corner[n][0]));
            most.y = std::max(most.y, std::abs(patch.corner[1][n] - patch.corner[0][n]));
        }
        return most;
    }
    // A Bezier curve is nowhere steeper than three times its steepest pair of control heights; chords of it are not either.
    const auto& c = patch.cubic.control;
    for (int n = 0; n < 4; ++n)
        for (int k = 0; k < 3; ++k) {
            most.x = std::max(most.x, 3 / kControlScale * std::abs(c[n][k + 1] - c[n][k]));
            most.y = std::max(most.y, 3 / kControlScale * std::abs(c[k + 1][n] - c[k][n]));
        }
    return most;
}

}  // namespace

Crossing stepwise_crossing(const CellPatch& patch, const MicroStructure& micro, const CellRay& ray) {
    const SteepestSlopes slopes = steepest_of_patch(patch);
    const double of_micro = steepest_slope(micro);
    const double fastest = std::abs(ray.to.z - ray.from.z) + (slopes.x + of_micro) * std::abs(ray.to.place.u - ray.from.place.u) +
                           (slopes.y + of_micro) * std::abs(ray.to.place.v - ray.from.place.v);
    const HeightRange range = patch.range();
    const double skin = kSkin * (range.highest - range.lowest + 2 * amplitude_of(micro));
    const auto gap_at = [&](double s) {
        const RayPoint point = ray.at(s);
        return point.z - surface_on(patch, micro, point.place).height;
    };
    const double start = ray.from.z - surface_on(patch, micro, ray.from.place).height;
    const double end = ray.to.z - surface_on(patch, micro, ray.to.place).height;
    const double sign = start < 0 ? -1 : 1;
    Crossing found;
    found.is_from_below = start < 0;
    double s = 0, gap = sign * start;
    for (int step = 0; step < kMaxSteps && gap > skin && s < 1; ++step) {
        s = fastest > 0 ? std::min(s + gap / fastest, 1.0) : 1.0;
        gap = s < 1 ? sign * gap_at(s) : sign * end;
    }
    found.s = s;
    found.is_hit = s < 1 ? true : gap <= 0;
    return found;
}

}  // namespace tedavis::raytrace
