/// Builds prisms of a scene's areas from floor to ceiling: airspaces, no-go areas, storm cells, buildings.
///
/// Attributes that are read where the layer has them: "floor" and "ceiling" in metres, with "floor_datum" and "ceiling_datum"
/// (classes "msl", "ground", "standard"; the layer's datum else; "standard" is drawn as over mean sea level); "height" over the
/// ground for those without a ceiling; "speed" (m/s) and "toward" (rad) of moving areas. An unknown floor is the ground, an
/// unknown ceiling is kUnknownCeiling_m. A size attribute replaces the height: value times size_m divided by the attribute's
/// largest value. For heights above the ground, the ground is sampled at every corner; corners are at most kLongestSide_m
/// apart.
///
/// `detail`: below 1 an area has fewer corners; the simplified area contains the true one and is larger by up to
/// kMaxOutlineGrowth (at detail 0). Buildings with a small "height" are left out (feature_importance.hpp).
///
/// Storm cells with "speed" and "toward" have a line with barbs (cell_motion.hpp) that begins at their front, and a time at its
/// farthest barb (motion_times.hpp).
///
/// Pure, apart from queries to the ground. Bounded: the square of an area's corners, kMaxPolygonCorners at most, eight times
/// with simplification.
#pragma once

#include "render_core/draw/data/cell_motion.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kUnknownCeiling_m = 15'000;
inline constexpr double kLongestSide_m = 2'000;
inline constexpr double kMaxOutlineGrowth = 0.5;

/// An area is drawn or hidden as a whole.
[[nodiscard]] ElementCount add_area_prisms(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

/// Returns where the line of a cell's motion begins; unknown where the cell has no place. The mesh is scratch memory.
[[nodiscard]] CellFront cell_front(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature);

/// True for layers that move with time: they are built again in every frame.
[[nodiscard]] bool prisms_move(const scene::Layer& layer);

}  // namespace tedavis::draw
