#include "render_core/raytrace/shading/ray_capsule.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tedavis::raytrace {
namespace {

constexpr double kNoTime = std::numeric_limits<double>::infinity();

struct RayStretch {
    double enters = kNoTime, leaves = -kNoTime;  ///< empty where it enters later than it leaves

    void include(const RayStretch& other) {
        enters = std::min(enters, other.enters);
        leaves = std::max(leaves, other.leaves);
    }
};

/// Within a ball; s counts in lengths of the unit direction.
RayStretch within_ball(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& centre, double radius) {
    const double nearest = glm::dot(centre - origin, direction);
    const glm::dvec3 aside = (origin - centre) + nearest * direction;
    const double square = radius * radius - glm::dot(aside, aside);
    if (square < 0) return {};
    const double half = std::sqrt(square);
    return {nearest - half, nearest + half};
}

/// Within a round bar without its end balls; the ends are planes.
RayStretch within_bar(const glm::dvec3& origin, const glm::dvec3& direction, const Capsule& capsule) {
    const glm::dvec3 axis = capsule.to - capsule.from;
    const double length = glm::length(axis);
    if (!(length > 0)) return {};
    const glm::dvec3 along = axis / length;
    const glm::dvec3 start = origin - capsule.from;
    const double rate = glm::dot(direction, along), at_start = glm::dot(start, along);
    const glm::dvec3 across = direction - rate * along, beside = start - at_start * along;
    const double square = glm::dot(across, across);
    RayStretch span{-kNoTime, kNoTime};
    if (square > 1e-24) {
        const double nearest = -glm::dot(beside, across) / square;
        const glm::dvec3 aside = beside + nearest * across;
        const double left = capsule.radius * capsule.radius - glm::dot(aside, aside);
        if (left < 0) return {};
        const double half = std::sqrt(left / square);
        span = {nearest - half, nearest + half};
    } else if (glm::dot(beside, beside) > capsule.radius * capsule.radius) {
        return {};
    }
    if (std::abs(rate) < 1e-300) return at_start >= 0 && at_start <= length ? span : RayStretch{};
    const double a = -at_start / rate, b = (length - at_start) / rate;
    span.enters = std::max(span.enters, std::min(a, b));
    span.leaves = std::min(span.leaves, std::max(a, b));
    return span.enters <= span.leaves ? span : RayStretch{};
}

}  // namespace

CapsuleHit ray_capsule(const glm::dvec3& origin, const glm::dvec3& direction, double from_t, const Capsule& capsule) {
    const double length = glm::length(direction);
    const glm::dvec3 unit = direction / length;
    // A capsule is convex: it is one span, from the first to the last of its parts'.
    RayStretch span = within_ball(origin, unit, capsule.from, capsule.radius);
    span.include(within_ball(origin, unit, capsule.to, capsule.radius));
    span.include(within_bar(origin, unit, capsule));
    CapsuleHit hit;
    const double start = from_t * length;
    if (span.enters > span.leaves || span.leaves < start) return hit;
    hit.is_hit = true;
    hit.is_from_inside = span.enters < start;
    const double s = hit.is_from_inside ? span.leaves : span.enters;
    hit.t = s / length;
    const glm::dvec3 point = origin + s * unit, axis = capsule.to - capsule.from;
    const double square = glm::dot(axis, axis);
    hit.along = square > 0 ? std::clamp(glm::dot(point - capsule.from, axis) / square, 0.0, 1.0) : 0;
    hit.normal = glm::normalize(point - (capsule.from + hit.along * axis));
    return hit;
}

}  // namespace tedavis::raytrace
