/// Builds obstacles in their shapes and true sizes: masts with guys, wind turbines, chimneys, cranes, poles; cables as walls
/// between their poles.
///
/// A point's kind is the class of its attribute "kind" (icons.hpp); others are obelisks. Its top and its foot are those of
/// scene/obstacle_stand.hpp; an obstacle of unknown height is scene::kUnknownObstacle_m high, in the colour of missing data.
/// White bands alternate with its colour, which is that of the alert where there is one (obstacle_color.hpp).
///
/// A line is a cable, drawn as a barrier: a translucent wall from the straight lines between the tops down to the ground, with a
/// solid upper edge as thick as "diameter" says, kCable_m else, so that what is thinner than a pixel does not look like a gap to
/// fly through. The edge is the line that the obstacle alert watches (policy/obstacle_ahead.hpp); a cable sags below it. Without
/// heights, or with heights over the ground, its points are poles ("height", scene::kPole_m else). With absolute heights they are
/// taken as surveyed, and poles stand at the ends.
///
/// The wall follows the ground in steps of kWallStep_m (longer ones where the line would need more than kMaxWallSteps) and goes
/// kWallRoot_m into it, so that it has no gap to the drawn ground, which deviates from the true one by about a pixel. Where the
/// ground is unknown it goes from foot to foot of its ends. It casts no shadow. Without room for a wall poles and edge stand
/// alone.
///
/// Objects thinner than a pixel stay visible: opaque ones have a rim of kMinHalf_px in the same colour, or the element's halo,
/// which shows the position and not the thickness.
///
/// `detail`: no obstacle is ever left out. From 1 down to kShapesFrom there are fewer bands; below, each is one body of its true
/// height that contains its shape, guys and all that a rotor or a jib may sweep. Cables are the same at every detail.
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kCable_m = 0.05;
inline constexpr double kWallStep_m = 50, kWallRoot_m = 20, kMaxWallSteps = 1024;
inline constexpr float kWallShare = 0.35f;  ///< opacity of a wall, as a share of the element's
inline constexpr double kShapesFrom = 0.5;
inline constexpr float kMinHalf_px = 1.0f;

/// A point or a line is drawn or hidden as a whole.
[[nodiscard]] ElementCount add_obstacle_points(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);
[[nodiscard]] ElementCount add_cables(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
