/// Areas of a scene from their floor to their ceiling: airspaces, no-go areas, storm cells, buildings.
///
/// Attributes that are read where the layer has them: "floor" and "ceiling" in metres, with "floor_datum" and "ceiling_datum"
/// (classes "msl", "ground", "standard"; the layer's datum else; "standard" is drawn as over mean sea level); "height" over the
/// ground for those without a ceiling; "speed" (m/s) and "toward" (rad) of what moves. A floor that is not known is the ground, a
/// ceiling that is not known is kUnknownCeiling_m. A size attribute stands for the height instead: value times size_m over the
/// attribute's largest. Along the ground's datum heights are taken at every corner, two of which are at most kLongestSide_m
/// apart.
///
/// `detail`: below 1 an area has fewer corners; it contains the true one, and covers up to kMaxOutlineGrowth (at detail 0) more
/// of the ground than it. Of buildings, those whose "height" is small are left out (feature_importance.hpp).
///
/// What has a "speed" and "toward" has an arrow (cell_motion.hpp) from its foremost place on.
///
/// Pure but for the ground that is asked. Bounded: the square of an area's corners, kMaxPolygonCorners at most, eight times
/// where they become fewer.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kUnknownCeiling_m = 15'000;
inline constexpr double kLongestSide_m = 2'000;
inline constexpr double kMaxOutlineGrowth = 0.5;

/// An area is drawn or hidden as a whole.
[[nodiscard]] ElementCount add_area_prisms(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

/// True for layers of what moves with time: they are built anew every frame.
[[nodiscard]] bool prisms_move(const scene::Layer& layer);

}  // namespace tedavis::draw
