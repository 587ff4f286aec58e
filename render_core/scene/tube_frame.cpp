#include "render_core/scene/tube_frame.hpp"

#include <cmath>

namespace tedavis::scene {
namespace {

constexpr double kMinAcross = 1e-6;      // of a unit vector, for its direction across another to mean something
constexpr double kMinReflection = 1e-6;  // between unit vectors, for the plane between them to mean something

glm::dvec3 reflected(const glm::dvec3& v, const glm::dvec3& across, double across_squared) {
    return v - (2 * glm::dot(across, v) / across_squared) * across;
}

glm::dvec3 axis_most_across(const glm::dvec3& tangent) {
    const double x = std::abs(tangent.x), y = std::abs(tangent.y), z = std::abs(tangent.z);
    if (z <= x && z <= y) return {0, 0, 1};
    return x <= y ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
}

glm::dvec3 part_across(const glm::dvec3& v, const glm::dvec3& tangent) { return v - glm::dot(v, tangent) * tangent; }

}  // namespace

glm::dvec3 normal_towards(const glm::dvec3& wanted, const glm::dvec3& tangent) noexcept {
    const glm::dvec3 across = part_across(wanted, tangent);
    const double length = glm::length(across);
    if (length > kMinAcross * glm::length(wanted)) return across / length;
    return glm::normalize(part_across(axis_most_across(tangent), tangent));
}

TubeFrame carried(const TubeFrame& frame, const glm::dvec3& step, const glm::dvec3& tangent) noexcept {
    glm::dvec3 normal = frame.normal, turned = frame.tangent;
    const double step_squared = glm::dot(step, step);
    if (step_squared > 0) {
        normal = reflected(normal, step, step_squared);
        turned = reflected(turned, step, step_squared);
    }
    const glm::dvec3 between = tangent - turned;
    const double between_squared = glm::dot(between, between);
    if (between_squared > kMinReflection * kMinReflection) normal = reflected(normal, between, between_squared);
    return {tangent, normal_towards(normal, tangent)};
}

}  // namespace tedavis::scene
