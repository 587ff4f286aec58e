#include "host_sim/clearance/triangle_place.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace tedavis::host_sim {
namespace {

glm::dvec3 nearest_of_line(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 way = b - a;
    const double length2 = glm::dot(way, way);
    return length2 > 0 ? a + std::clamp(-glm::dot(a, way) / length2, 0.0, 1.0) * way : a;
}

/// Keeps the part of a convex polygon that lies in the half-space.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, const HalfSpace& half) {
    std::vector<glm::dvec3> kept;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const glm::dvec3 &from = polygon[n], &to = polygon[(n + 1) % polygon.size()];
        const double in_from = glm::dot(half.normal, from) - half.offset, in_to = glm::dot(half.normal, to) - half.offset;
        if (in_from >= 0) kept.push_back(from);
        if ((in_from < 0) != (in_to < 0)) kept.push_back(from + in_from / (in_from - in_to) * (to - from));
    }
    return kept;
}

}  // namespace

glm::dvec3 nearest_to_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area2 = glm::dot(normal, normal);
    if (area2 > 0) {
        const glm::dvec3 foot = glm::dot(a, normal) / area2 * normal;
        const auto is_left = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return glm::dot(glm::cross(to - from, foot - from), normal) >= 0;
        };
        if (is_left(a, b) && is_left(b, c) && is_left(c, a)) return foot;
    }
    glm::dvec3 nearest = nearest_of_line(a, b);
    for (const glm::dvec3& place : {nearest_of_line(b, c), nearest_of_line(c, a)})
        if (glm::dot(place, place) < glm::dot(nearest, nearest)) nearest = place;
    return nearest;
}

std::optional<glm::dvec3> nearest_to_origin(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Region& region) {
    if (region.empty()) return nearest_to_origin(a, b, c);
    std::vector<glm::dvec3> polygon{a, b, c};
    for (const HalfSpace& half : region) polygon = clipped(polygon, half);
    std::optional<glm::dvec3> nearest;
    for (std::size_t n = 2; n < polygon.size(); ++n) {
        const glm::dvec3 place = nearest_to_origin(polygon[0], polygon[n - 1], polygon[n]);
        if (!nearest || glm::dot(place, place) < glm::dot(*nearest, *nearest)) nearest = place;
    }
    return nearest;
}

}  // namespace tedavis::host_sim
