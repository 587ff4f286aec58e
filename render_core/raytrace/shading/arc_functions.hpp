/// Angles by additions, multiplications, divisions and square roots alone: the same bits on every machine, which the functions of
/// the C library are not (NUMERICS finding 2). What is precomputed with them and rounded to few bits is then the same everywhere.
#pragma once

#include <glm/vec2.hpp>

namespace tedavis::raytrace {

inline constexpr double kArcPi = 3.14159265358979323846;

/// Of any number, infinity included; error below 1e-15.
[[nodiscard]] double arc_tangent(double x);

/// Of a number that is cut to -1..1; 0..pi, error below 1e-15 + 1e-16 / sine.
[[nodiscard]] double arc_cosine(double x);

/// (cosine, sine) of an angle of -2 pi..2 pi; error below 1e-15. Multiples of a quarter turn are exact where the angle is
/// turn * kArcPi / 2 for a whole number.
[[nodiscard]] glm::dvec2 direction_of_angle(double angle_rad);

}  // namespace tedavis::raytrace
