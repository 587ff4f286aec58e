/// Inverse trigonometric functions from additions, multiplications, divisions and square roots alone. Unlike those of the C
/// library, they give the same bits on every machine, and so do maps computed from them.
#pragma once

#include <glm/vec2.hpp>

namespace tedavis::raytrace {

inline constexpr double kArcPi = 3.14159265358979323846;

/// Arc tangent of any number, infinity included; error below 1e-15.
[[nodiscard]] double arc_tangent(double x);

/// Arc cosine, 0..pi, of a number that is clamped to -1..1; error below 1e-15 + 1e-16 / sine.
[[nodiscard]] double arc_cosine(double x);

/// (cosine, sine) of an angle of -2 pi..2 pi; error below 1e-15. Multiples of a quarter turn are exact where the angle is
/// n * kArcPi / 2 for an integer n.
[[nodiscard]] glm::dvec2 direction_of_angle(double angle_rad);

}  // namespace tedavis::raytrace
