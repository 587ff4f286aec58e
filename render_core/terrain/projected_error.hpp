/// Upper bound of a chunk's error in a view, in pixels, and a conservative test whether a chunk is in the view.
///
/// A point drawn at a place on the screen with off-axis tangents (x, y), by e above or below the true one, lies e * focal *
/// |u_xy - (x, y) u_z| / z pixels from it: u is the vertical in the view's axes, z the true point's depth (difference of the
/// two projections). In a flat view boxes are those of the drawn plane, while errors are still those of the relief, an upper
/// bound. Where magnifiers of the view reach, boxes are those of the moved ground; errors of height are unchanged. Boxes are
/// ECEF; pure functions; any thread.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/earth/magnified_parts.hpp"
#include "render_core/terrain/tdb_format.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Returns true when no point of the chunk's box, stretched upwards by `lift_m`, can be in the view; never for a visible chunk.
/// A chunk outside a view is outside every narrower one of the same pose.
[[nodiscard]] bool is_outside_view(const ChunkEntry& entry, const View& view, double lift_m = 0);

/// Returns the largest displacement in pixels of a vertical error of `error_m` anywhere in the picture and in the chunk's box,
/// stretched upwards by `lift_m`. Exactly 0 for no error; infinite where there is no bound; never NaN.
[[nodiscard]] double error_in_box_px(const ChunkEntry& entry, const View& view, double error_m, double lift_m);

/// Returns the greatest off-axis tangent along `up` (a unit vector in the picture: right, down) of any point of the chunk's
/// box, stretched upwards by `lift_m`. Minus infinity for a box behind the near plane, infinity where there is no bound; never
/// NaN.
[[nodiscard]] double highest_tangent(const ChunkEntry& entry, const View& view, const glm::dvec2& up, double lift_m);

/// Least and greatest depth of the chunk's box along the view, stretched by `lift_m` both ways.
struct DepthSpan {
    double near_m = 0, far_m = 0;
};
[[nodiscard]] constexpr bool overlap(const DepthSpan& a, const DepthSpan& b) {
    return a.far_m >= b.near_m && a.near_m <= b.far_m;
}
[[nodiscard]] DepthSpan depth_span(const ChunkEntry& entry, const View& view, double lift_m);

/// Returns a bound of the chunk's ground, with and without `lift_m`.
[[nodiscard]] earth::GroundExtent extent_of(const ChunkEntry& entry, double lift_m);
/// Number of draw calls for a chunk: more than 1 where magnifiers of the view reach it.
[[nodiscard]] std::uint32_t draws_of(const ChunkEntry& entry, const View& view, double lift_m);

/// Largest factor by which the view's magnifiers enlarge lengths of the chunk's ground; 1 where none reaches it.
[[nodiscard]] double magnification(const ChunkEntry& entry, const View& view);

/// Distances from the eye point to the chunk's centre and to its box (0 inside).
[[nodiscard]] float distance_m(const ChunkEntry& entry, const View& view);
[[nodiscard]] double box_distance_m(const ChunkEntry& entry, const View& view);

}  // namespace tedavis::terrain
