/// A curve with known derivatives, and its rotation minimising frames from their differential equation.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render_core/scene/tube_frame.hpp"

namespace tedavis::test_support {

/// A knot on a torus, for u in 0..2 pi; turns and twists everywhere.
struct KnotCurve {
    double size = 1;

    [[nodiscard]] glm::dvec3 at(double u) const {
        const double r = 2 + std::cos(3 * u);
        return size * glm::dvec3(r * std::cos(2 * u), r * std::sin(2 * u), std::sin(3 * u));
    }
    [[nodiscard]] glm::dvec3 velocity(double u) const {
        const double r = 2 + std::cos(3 * u), dr = -3 * std::sin(3 * u);
        return size * glm::dvec3(dr * std::cos(2 * u) - 2 * r * std::sin(2 * u), dr * std::sin(2 * u) + 2 * r * std::cos(2 * u),
                                 3 * std::cos(3 * u));
    }
    [[nodiscard]] glm::dvec3 tangent(double u) const { return glm::normalize(velocity(u)); }
    /// Change of the unit tangent with u.
    [[nodiscard]] glm::dvec3 bend(double u) const {
        const double r = 2 + std::cos(3 * u), dr = -3 * std::sin(3 * u), ddr = -9 * std::cos(3 * u);
        const double c = std::cos(2 * u), s = std::sin(2 * u);
        const glm::dvec3 v = velocity(u);
        const glm::dvec3 a =
            size * glm::dvec3((ddr - 4 * r) * c - 4 * dr * s, (ddr - 4 * r) * s + 4 * dr * c, -9 * std::sin(3 * u));
        const glm::dvec3 t = glm::normalize(v);
        return (a - glm::dot(a, t) * t) / glm::length(v);
    }
};

/// The normal n from u = 0 to `end` by n' = -(n . t') t, with classical Runge-Kutta steps.
inline glm::dvec3 integrated_normal(const KnotCurve& curve, const glm::dvec3& begin, double end, int steps) {
    const auto change = [&](double u, const glm::dvec3& n) { return -glm::dot(n, curve.bend(u)) * curve.tangent(u); };
    glm::dvec3 n = begin;
    const double h = end / steps;
    for (int k = 0; k < steps; ++k) {
        const double u = k * h;
        const glm::dvec3 a = change(u, n), b = change(u + h / 2, n + h / 2 * a), c = change(u + h / 2, n + h / 2 * b);
        n += h / 6 * (a + 2.0 * b + 2.0 * c + change(u + h, n + h * c));
    }
    return n;
}

/// The frame's normal after the least rotation that turns its tangent to another one (Rodrigues, without the angle).
inline glm::dvec3 least_rotated(const scene::TubeFrame& frame, const glm::dvec3& tangent) {
    const glm::dvec3 axis = glm::cross(frame.tangent, tangent);
    const double cosine = glm::dot(frame.tangent, tangent);
    return cosine * frame.normal + glm::cross(axis, frame.normal) + glm::dot(axis, frame.normal) / (1 + cosine) * axis;
}

/// What `to` is turned about its tangent beyond the least rotation from `from`, rad.
inline double twist_between(const scene::TubeFrame& from, const scene::TubeFrame& to) {
    const glm::dvec3 least = least_rotated(from, to.tangent);
    return std::atan2(glm::dot(glm::cross(least, to.normal), to.tangent), glm::dot(least, to.normal));
}

inline bool is_orthonormal(const scene::TubeFrame& frame) {
    // NaN is none.
    return std::abs(glm::length(frame.tangent) - 1) < 1e-6 && std::abs(glm::length(frame.normal) - 1) < 1e-6 &&
           std::abs(glm::dot(frame.tangent, frame.normal)) < 1e-6 && std::abs(glm::length(frame.binormal()) - 1) < 1e-6;
}

}  // namespace tedavis::test_support
