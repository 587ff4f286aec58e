/// Closed shapes of which solids are composed, with outward faces: frusta, boxes, ellipsoids. Pure; a shape that does not fit
/// makes the mesh incomplete (solid_mesh.hpp).
#pragma once

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr int kMaxShapeSides = 12;

/// Adds a frustum about the line between two places (ECEF), capped at both ends; a second radius of 0 gives a tip. `sides` is
/// 3..kMaxShapeSides; normals are those of a round frustum, so that rims grow evenly. `across` is the direction of the first edge
/// from the axis, not parallel to it. Adds nothing where both ends are equal.
void add_frustum(SolidMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double from_radius_m, double to_radius_m,
                 int sides, const glm::dvec3& across);

/// Adds a box: its middle, and half of each edge; the three are perpendicular and right-handed.
void add_box(SolidMesh& mesh, const glm::dvec3& middle, const glm::dvec3& half_x, const glm::dvec3& half_y,
             const glm::dvec3& half_z);

/// Adds an ellipsoid with smooth normals; `level_m` and `upright_m` are its horizontal and vertical semi-axes.
void add_ellipsoid(SolidMesh& mesh, const glm::dvec3& middle, const LocalAxes& axes, double level_m, double upright_m);

}  // namespace tedavis::draw
