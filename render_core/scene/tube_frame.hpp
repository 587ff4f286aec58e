/// Frames along a curve that turn about it as little as possible.
///
/// Units and axes are the caller's. Pure functions; any thread.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace tedavis::scene {

/// Right-handed: tangent, normal, binormal; unit vectors.
struct TubeFrame {
    glm::dvec3 tangent{1, 0, 0};
    glm::dvec3 normal{0, 0, 1};

    [[nodiscard]] glm::dvec3 binormal() const { return glm::cross(tangent, normal); }
};

/// The unit vector across a unit tangent that is nearest to `wanted`; where that is zero or along the tangent, nearest to the
/// axis that is most across it.
[[nodiscard]] glm::dvec3 normal_towards(const glm::dvec3& wanted, const glm::dvec3& tangent) noexcept;

/// The frame after a step along the curve: double reflection (W. Wang, B. Jüttler, D. Zheng, Y. Liu, Computation of rotation
/// minimizing frames, ACM Transactions on Graphics 27(1), 2008). With the curve's own tangents the error at a given place falls
/// with the fourth power of the step. A tangent turned round, with the step along it, keeps the normal: a half turn about it.
[[nodiscard]] TubeFrame carried(const TubeFrame& frame, const glm::dvec3& step, const glm::dvec3& tangent) noexcept;

}  // namespace tedavis::scene
