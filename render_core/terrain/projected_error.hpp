/// How many pixels an error of a chunk can be in a view, and whether a chunk can be in the view at all.
///
/// A point drawn at a place on the screen with off-axis tangents (x, y), by e above or below the true one, lies
/// e * focal * |u_xy - (x, y) u_z| / z pixels from it: u is the vertical in the view's axes, z the true point's depth
/// (difference of the two projections). In a flat view boxes are those of what is drawn, and errors still those of the relief:
/// what is drawn has no more. Where magnifiers of the view reach, boxes are those of what is drawn, too; errors of height stay
/// what they are. Boxes are ECEF; pure functions; any thread.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/earth/magnified_parts.hpp"
#include "render_core/terrain/tdb_format.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// True when no point of the chunk's box, stretched upwards by `lift_m`, can be in the view. Never true for a visible one. What
/// is outside a view is outside every narrower one of the same pose.
[[nodiscard]] bool is_outside_view(const ChunkEntry& entry, const View& view, double lift_m = 0);

/// Largest number of pixels that a vertical error of `error_m` can be anywhere in the picture and in the chunk's box, stretched
/// upwards by `lift_m`. Exactly 0 for no error; never NaN: what cannot be bounded is infinite.
[[nodiscard]] double error_in_box_px(const ChunkEntry& entry, const View& view, double error_m, double lift_m);

/// How far up along `up` (unit, parts along the picture's right and down) any point of the chunk's box, stretched upwards by
/// `lift_m`, is seen: its greatest off-axis tangent. Minus infinity for a box behind the near plane. Never NaN: what cannot be
/// bounded is infinite.
[[nodiscard]] double highest_tangent(const ChunkEntry& entry, const View& view, const glm::dvec2& up, double lift_m);

/// Least and greatest depth of the chunk's box along the view, stretched by `lift_m` both ways.
struct DepthSpan {
    double near_m = 0, far_m = 0;
};
[[nodiscard]] constexpr bool overlap(const DepthSpan& a, const DepthSpan& b) {
    return a.far_m >= b.near_m && a.near_m <= b.far_m;
}
[[nodiscard]] DepthSpan depth_span(const ChunkEntry& entry, const View& view, double lift_m);

/// Where the chunk's ground may lie, raised by `lift_m` or not.
[[nodiscard]] earth::GroundExtent extent_of(const ChunkEntry& entry, double lift_m);
/// Draws that a chunk takes: more than 1 where magnifiers of the view reach it.
[[nodiscard]] std::uint32_t draws_of(const ChunkEntry& entry, const View& view, double lift_m);

/// By how much the view's magnifiers draw a length of the chunk's ground longer at most; 1 where none reaches it.
[[nodiscard]] double magnification(const ChunkEntry& entry, const View& view);

/// From the eye to the chunk's centre; and to its box, 0 inside.
[[nodiscard]] float distance_m(const ChunkEntry& entry, const View& view);
[[nodiscard]] double box_distance_m(const ChunkEntry& entry, const View& view);

}  // namespace tedavis::terrain
