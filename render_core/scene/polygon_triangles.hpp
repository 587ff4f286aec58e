/// Triangulates a simple polygon by ear clipping (G. Meisters, Polygons have ears, American Mathematical Monthly 82, 1975).
///
/// Units are the caller's. Memory  the caller's. Bounded: the square of the corners' number. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::scene {

inline constexpr std::size_t kMaxPolygonCorners = 1024;

/// Returns twice the signed area; positive when counter-clockwise.
[[nodiscard]] double twice_area(base::Span<const glm::dvec2> corners) noexcept;

/// Writes corner indices, three per triangle, counter-clockwise whatever the polygon's orientation, and returns their number,
/// at most 3 * (corners - 2). A polygon that crosses itself is triangulated approximately. Returns 0 for fewer than three
/// corners, more than kMaxPolygonCorners, or too little room.
[[nodiscard]] std::size_t triangulate(base::Span<const glm::dvec2> corners, base::Span<std::uint16_t> triangles) noexcept;

}  // namespace tedavis::scene
