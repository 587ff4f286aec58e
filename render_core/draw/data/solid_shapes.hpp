/// Closed shapes of which solids are composed, with outward faces: frusta, boxes, ellipsoids. Pure; a shape that does not fit
/// makes the mesh incomplete (solid_mesh.hpp).
#pragma once

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr int kMaxShapeSides = 12;

/// A frustum round the way from one place to another (ECEF), capped at both ends; a second radius of 0 is a tip. `sides`:
/// 3..kMaxShapeSides; normals are those of a round one, so that rims grow on all sides. `across`: a direction in which its first
/// edge lies, not along the way. Nothing where the ends are one.
void add_frustum(SolidMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double from_radius_m, double to_radius_m,
                 int sides, const glm::dvec3& across);

/// A box: its middle and half of its edges, which stand on each other, turning right-handed.
void add_box(SolidMesh& mesh, const glm::dvec3& middle, const glm::dvec3& half_x, const glm::dvec3& half_y,
             const glm::dvec3& half_z);

/// An ellipsoid with its axes along the local ones, normals smooth: half axes level and upright.
void add_ellipsoid(SolidMesh& mesh, const glm::dvec3& middle, const LocalAxes& axes, double level_m, double upright_m);

}  // namespace tedavis::draw
