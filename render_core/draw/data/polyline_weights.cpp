#include "render_core/draw/data/polyline_weights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tedavis::draw {
namespace {

struct Farthest {
    std::uint32_t point = 0;
    double distance_m = -1;
};

Farthest farthest_of(base::Span<const PolylineVertex> points, const PolylineStretch& stretch) {
    Farthest found;
    for (std::uint32_t n = stretch.first + 1; n < stretch.last; ++n) {
        const double distance_m = distance_from_segment(points[n], points[stretch.first], points[stretch.last]);
        if (distance_m > found.distance_m) found = {n, distance_m};
    }
    return found;
}

}  // namespace

double distance_from_segment(const PolylineVertex& point, const PolylineVertex& from, const PolylineVertex& to) noexcept {
    const glm::dvec3 way = to.place - from.place, gone = point.place - from.place;
    const double squared = glm::dot(way, way);
    const double share = squared > 0 ? std::clamp(glm::dot(gone, way) / squared, 0.0, 1.0) : 0;
    double distance_m = glm::distance(gone, share * way);
    for (std::size_t n = 0; n < point.values.size(); ++n) {
        const double expected = from.values[n] + share * (to.values[n] - from.values[n]);
        const double off = std::abs(point.values[n] - expected);
        if (off > distance_m) distance_m = off;  // never of what is not a number
    }
    return distance_m;
}

void weigh_vertices(base::Span<const PolylineVertex> points, base::Span<float> weights,
                    base::Span<PolylineStretch> waiting) noexcept {
    if (points.empty()) return;
    constexpr float kAll = std::numeric_limits<float>::infinity();
    const auto last = static_cast<std::uint32_t>(points.size() - 1);
    weights[0] = weights[last] = kAll;
    // Every stretch that is taken gives place to two with a point less between them: there are never more than points.
    std::size_t count = 0;
    if (last > 1) waiting[count++] = {0, last, kAll};
    while (count > 0) {
        const PolylineStretch stretch = waiting[--count];
        const Farthest farthest = farthest_of(points, stretch);
        const float weight_m = std::min(static_cast<float>(farthest.distance_m), stretch.weight_m);
        weights[farthest.point] = weight_m;
        if (farthest.point - stretch.first > 1) waiting[count++] = {stretch.first, farthest.point, weight_m};
        if (stretch.last - farthest.point > 1) waiting[count++] = {farthest.point, stretch.last, weight_m};
    }
}

}  // namespace tedavis::draw
