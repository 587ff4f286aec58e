/// A segment of a ray within one cell, and its hit there.
#pragma once

#include <algorithm>

#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::raytrace {

struct RayPoint {
    double t = 0;
    CellPlace place;
    double z = 0;
};

/// A segment from one point of a ray to a later one, both in (or on the sides of) one cell.
struct CellRay {
    RayPoint from, to;

    /// Returns the point at s, 0..1.
    [[nodiscard]] RayPoint at(double s) const {
        const auto between = [s](double a, double b) { return (1 - s) * a + s * b; };
        RayPoint point = from;
        point.t = between(from.t, to.t);
        point.place.u = std::clamp(between(from.place.u, to.place.u), 0.0, 1.0);
        point.place.v = std::clamp(between(from.place.v, to.place.v), 0.0, 1.0);
        point.z = between(from.z, to.z);
        return point;
    }
};

struct Crossing {
    bool is_hit = false;
    bool is_from_below = false;
    double s = 0;  ///< position on the segment, 0..1
};

}  // namespace tedavis::raytrace
