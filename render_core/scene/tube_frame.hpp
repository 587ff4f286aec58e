/// Rotation-minimising frames along a curve.
///
/// Units and axes are chosen by the caller. Pure functions; any thread.
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

/// Returns the unit vector perpendicular to a unit tangent that is nearest to `wanted`; where that is zero or along the
/// tangent, nearest to the coordinate axis that is most perpendicular to it.
[[nodiscard]] glm::dvec3 normal_towards(const glm::dvec3& wanted, const glm::dvec3& tangent) noexcept;

/// Returns the frame after a step along the curve, by double reflection (W. Wang, B. Jüttler, D. Zheng, Y. Liu, Computation of
/// rotation minimizing frames, ACM Transactions on Graphics 27(1), 2008). With the curve's exact tangents the error at a given
/// point decreases with the fourth power of the step. Where the tangent is reversed along the step, the normal is kept: the
/// frame rotates about it by a half turn.
[[nodiscard]] TubeFrame carried(const TubeFrame& frame, const glm::dvec3& step, const glm::dvec3& tangent) noexcept;

}  // namespace tedavis::scene
