/// Builds strips on the ground along lines: roads and rivers. Runways: runway_strips.hpp.
///
/// A strip follows the true ground: cross-sections at most kLongestStep_m apart, each kStripLift_m above the highest ground
/// below it, because terrain is drawn with a tolerance; where the ground is unknown it has the heights of its points. Widths:
/// attribute "width"; else the element's size_m; else the role's.
///
/// Strips (of any line) face upwards only, and look a few pixels wide where they are narrower.
///
/// `detail`: below 1 roads and rivers leave out points of their way, from which it is nowhere farther than
/// kMaxStraightened_m * (1 - detail), and those with a small "width" are left out (feature_importance.hpp).
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kMaxStraightened_m = 300;
inline constexpr double kRiverWidth_m = 20, kRoadWidth_m = 8;

/// A line is drawn or hidden as a whole, except where a ribbon exceeds the room.
[[nodiscard]] ElementCount add_ribbons(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
