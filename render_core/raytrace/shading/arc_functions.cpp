#include "render_core/raytrace/shading/arc_functions.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

/// |x| below tan(pi / 16).
double short_arc_tangent(double x) {
    const double square = x * x;
    double sum = 0;
    for (int n = 25; n >= 1; n -= 2) sum = 1.0 / n - square * sum;
    return x * sum;
}

}  // namespace

double arc_tangent(double x) {
    const double size = std::abs(x);
    const bool is_far = size > 1;
    double part = is_far ? 1 / size : size;
    // The tangent of half the angle, twice.
    for (int n = 0; n < 2; ++n) part /= 1 + std::sqrt(1 + part * part);
    const double angle = 4 * short_arc_tangent(part);
    return std::copysign(is_far ? kArcPi / 2 - angle : angle, x);
}

double arc_cosine(double x) {
    const double cut = std::clamp(x, -1.0, 1.0);
    return 2 * arc_tangent(std::sqrt((1 - cut) / (1 + cut)));
}

glm::dvec2 direction_of_angle(double angle_rad) {
    const double quarters = std::floor(angle_rad / (kArcPi / 2) + 0.5);
    const double rest = angle_rad - quarters * (kArcPi / 2), square = rest * rest;
    double cosine = 0, sine = 0;
    for (int n = 18; n >= 2; n -= 2) {
        cosine = (1 - square * cosine) / (n * (n - 1.0));
        sine = (1 - square * sine) / (n * (n + 1.0));
    }
    const glm::dvec2 turned(1 - square * cosine, rest * (1 - square * sine));
    switch (static_cast<int>(quarters) & 3) {
        case 1: return {-turned.y, turned.x};
        case 2: return -turned;
        case 3: return {turned.y, -turned.x};
        default: return turned;
    }
}

}  // namespace tedavis::raytrace
