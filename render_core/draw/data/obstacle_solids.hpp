/// Builds obstacles in their shapes and true sizes: masts with guys, wind turbines, chimneys, cranes, poles; cables with their
/// poles.
///
/// A point's kind is the class of its attribute "kind" (icons.hpp); others are obelisks. Its top and its foot are those of
/// scene/obstacle_stand.hpp; an obstacle of unknown height is scene::kUnknownObstacle_m high, in the colour of missing data.
/// White bands alternate with its colour, which is that of the alert where there is one (obstacle_color.hpp).
///
/// A line's cable is as thick as "diameter" says, kCable_m else. Without heights, or with heights over the ground, its points are
/// poles ("height", scene::kPole_m else), between which it sags by "sag", else by a kSagShare-th of the span, in a parabola. With
/// absolute heights it is taken as surveyed, its poles at its ends; it sags when it has two points only or a "sag".
///
/// Objects thinner than a pixel stay visible: opaque ones have a rim of kMinHalf_px in the same colour, or the element's halo,
/// which shows the position and not the thickness.
///
/// `detail`: no obstacle is ever left out. From 1 down to kShapesFrom there are fewer bands; below, each is one body of its true
/// height that contains its shape, guys and all that a rotor or a jib may sweep. Cables have fewer straight parts, none of them
/// below the true one.
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kCable_m = 0.05, kSagShare = 30;
inline constexpr double kShapesFrom = 0.5;
inline constexpr float kMinHalf_px = 1.0f;

/// A point or a line is drawn or hidden as a whole.
[[nodiscard]] ElementCount add_obstacle_points(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);
[[nodiscard]] ElementCount add_cables(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
