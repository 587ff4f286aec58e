/// How many pixels an error of a chunk can be in a view, and whether a chunk can be in the view at all.
///
/// A displacement e at view depth z and off-axis tangent rho moves the projected point by at most
/// e * focal * sqrt(1 + rho^2) / z = e * focal * (1 + rho^2) / distance pixels. Boxes are ECEF; pure functions; any thread.
#pragma once

#include "render_core/terrain/tdb_format.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// True when no point of the chunk's box, stretched upwards by `lift_m`, can be in the view. Never true for a visible one.
[[nodiscard]] bool is_outside_view(const ChunkEntry& entry, const View& view, double lift_m = 0);

/// Largest number of pixels that a displacement of `error_m` can be anywhere in the chunk's box, its sides grown by `grow` times
/// their half lengths and upwards by `lift_m`. Exactly 0 for no error; never NaN: what cannot be bounded is infinite.
[[nodiscard]] double error_in_box_px(const ChunkEntry& entry, const View& view, double error_m, double grow, double lift_m);

/// Of an unlifted chunk: `bound_m` also bounds the strips that finer neighbours coarsen towards it; those lie within half a
/// chunk of it, so its box is grown by that much.
[[nodiscard]] double projected_error_px(const ChunkEntry& entry, const View& view);

/// From the eye to the chunk's centre; and to its box, 0 inside.
[[nodiscard]] float distance_m(const ChunkEntry& entry, const View& view);
[[nodiscard]] double box_distance_m(const ChunkEntry& entry, const View& view);

}  // namespace tedavis::terrain
