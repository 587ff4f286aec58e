/// Projects directions of the world to the screen: the perspective that terrain, sky and conformal symbols share.
///
/// The view is along the aircraft's forward axis, whose vanishing point is the middle of the screen. The focal length in pixels
/// is equal in both directions (square pixels); the field of view applies to the width. Pixels as in rect.hpp.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "render_core/draw/rect.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

struct ViewFrame {
    double focal_px = 1;
    double center_x = 0, center_y = 0;
    glm::dmat3 body_axes{1.0};  ///< columns forward, right, down of the body in north, east, down
};

/// `width`, `height` in pixels; angles in radians as earth::body_axes takes them.
[[nodiscard]] ViewFrame make_view_frame(double width, double height, double horizontal_field_of_view_rad, double heading_rad,
                                        double pitch_rad, double roll_rad) noexcept;

/// Returns the view with which the terrain is drawn, in the local frame below the eye point.
[[nodiscard]] ViewFrame make_view_frame(const terrain::View& view) noexcept;

struct ProjectedPoint {
    Point at;
    bool in_front = false;  ///< false: behind the eye or more than 89 degrees off; `at` is meaningless
};
/// `direction`: north, east, down; any length but zero.
[[nodiscard]] ProjectedPoint project(const ViewFrame& view, const glm::dvec3& direction) noexcept;

/// The view ray of a screen point: north, east, down, not of unit length.
[[nodiscard]] glm::dvec3 ray_of(const ViewFrame& view, double x, double y) noexcept;

/// Unit vector of a heading from north and an elevation above the horizontal.
[[nodiscard]] glm::dvec3 direction_of(double heading_rad, double elevation_rad) noexcept;

/// Dip of the visible horizon below the horizontal for an eye point at a height above the sphere: acos(R / (R + h)), with the
/// Earth's mean radius; 0 for heights at or below the surface. No refraction.
[[nodiscard]] double horizon_dip_rad(double height_m) noexcept;

}  // namespace tedavis::draw
