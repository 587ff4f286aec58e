#include "render_core/raytrace/shading/cap_overlap.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

/// 1 - cosine, without losing the digits of small angles.
double versine(double angle_rad) {
    const double half = direction_of_angle(angle_rad / 2).y;
    return 2 * half * half;
}

/// The angle at a corner of a spherical triangle from its three sides, by half-side sines: no digits lost in thin triangles.
double corner_angle(double opposite, double side_a, double side_b) {
    const double half = (opposite + side_a + side_b) / 2;
    const auto sine = [](double x) { return std::max(0.0, direction_of_angle(x).y); };
    const double over = sine(half - side_a) * sine(half - side_b), under = sine(half) * sine(half - opposite);
    return 2 * arc_tangent(std::sqrt(under > 0 ? over / under : HUGE_VAL));
}

}  // namespace

double cap_area(double radius_rad) { return 2 * kArcPi * versine(radius_rad); }

double cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad) {
    const double smaller = std::min(radius_a_rad, radius_b_rad), larger = std::max(radius_a_rad, radius_b_rad);
    if (distance_rad >= smaller + larger) return 0;
    if (distance_rad <= larger - smaller) return cap_area(smaller);
    // The circles meet in two points; each with both centres makes the same triangle. Two sectors less two triangles.
    const double at_small = corner_angle(larger, smaller, distance_rad), at_large = corner_angle(smaller, larger, distance_rad);
    const double at_meeting = corner_angle(distance_rad, smaller, larger);
    const double sectors = 2 * at_small * versine(smaller) + 2 * at_large * versine(larger);
    const double triangles = 2 * (at_small + at_large + at_meeting - kArcPi);
    return std::clamp(sectors - triangles, 0.0, cap_area(smaller));
}

double smooth_cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad) {
    const double smaller = std::min(radius_a_rad, radius_b_rad), larger = std::max(radius_a_rad, radius_b_rad);
    if (distance_rad >= smaller + larger) return 0;
    if (distance_rad <= larger - smaller) return cap_area(smaller);
    const double t = 1 - (distance_rad - (larger - smaller)) / (2 * smaller);
    return cap_area(smaller) * (t * t * (3 - 2 * t));
}

}  // namespace tedavis::raytrace
