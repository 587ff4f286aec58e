#include "render_core/draw/view_frame.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kCosineOfWidest = 0.0174524064372835;  // 89 degrees

}  // namespace

ViewFrame make_view_frame(double width, double height, double horizontal_field_of_view_rad, double heading_rad, double pitch_rad,
                          double roll_rad) noexcept {
    const double cos_h = std::cos(heading_rad), sin_h = std::sin(heading_rad);
    const double cos_p = std::cos(pitch_rad), sin_p = std::sin(pitch_rad);
    const double cos_r = std::cos(roll_rad), sin_r = std::sin(roll_rad);
    ViewFrame view;
    view.focal_px = width / 2 / std::tan(horizontal_field_of_view_rad / 2);
    view.center_x = width / 2;
    view.center_y = height / 2;
    view.body_axes[0] = {cos_p * cos_h, cos_p * sin_h, -sin_p};
    view.body_axes[1] = {sin_r * sin_p * cos_h - cos_r * sin_h, sin_r * sin_p * sin_h + cos_r * cos_h, sin_r * cos_p};
    view.body_axes[2] = {cos_r * sin_p * cos_h + sin_r * sin_h, cos_r * sin_p * sin_h - sin_r * cos_h, cos_r * cos_p};
    return view;
}

ViewFrame make_view_frame(const terrain::View& view) noexcept {
    const earth::Geodetic place = earth::from_ecef(view.eye);
    const glm::dmat3 to_local = glm::transpose(earth::north_east_down(place.latitude_rad, place.longitude_rad));
    ViewFrame frame;
    frame.focal_px = view.focal_px;
    frame.center_x = 0.5 * view.width;
    frame.center_y = 0.5 * view.height;
    frame.body_axes = to_local * glm::dmat3(view.forward, view.right, view.down);
    return frame;
}

ProjectedPoint project(const ViewFrame& view, const glm::dvec3& direction) noexcept {
    const double forward = glm::dot(view.body_axes[0], direction);
    if (!(forward > kCosineOfWidest * glm::length(direction))) return {};
    const double x = view.center_x + view.focal_px * glm::dot(view.body_axes[1], direction) / forward;
    const double y = view.center_y + view.focal_px * glm::dot(view.body_axes[2], direction) / forward;
    return {{static_cast<float>(x), static_cast<float>(y)}, true};
}

glm::dvec3 ray_of(const ViewFrame& view, double x, double y) noexcept {
    return view.body_axes[0] + view.body_axes[1] * ((x - view.center_x) / view.focal_px) +
           view.body_axes[2] * ((y - view.center_y) / view.focal_px);
}

glm::dvec3 direction_of(double heading_rad, double elevation_rad) noexcept {
    return {std::cos(elevation_rad) * std::cos(heading_rad), std::cos(elevation_rad) * std::sin(heading_rad),
            -std::sin(elevation_rad)};
}

double horizon_dip_rad(double height_m) noexcept {
    if (!(height_m > 0)) return 0;
    // atan2 of the tangent's length and the radius: acos near 1 would lose the small angles.
    return std::atan2(std::sqrt(height_m * (2 * earth::kMeanRadius_m + height_m)), earth::kMeanRadius_m);
}

}  // namespace tedavis::draw
