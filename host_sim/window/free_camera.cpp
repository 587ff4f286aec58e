#include "host_sim/window/free_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSteepestPitch_rad = base::radians(89);
constexpr double kNotch = 1.25, kSlowest_mps = 1, kFastest_mps = 50'000;
/// The camera stays where the Earth's surface is below it and terrain makes sense.
constexpr double kLowest_m = -1000, kHighest_m = 100'000;

glm::dmat3 axes_of(const CameraPose& pose) {
    return earth::body_axes(pose.position.latitude_rad, pose.position.longitude_rad, pose.heading_rad, pose.pitch_rad,
                            pose.roll_rad);
}

}  // namespace

terrain::View view_of(const CameraPose& pose, std::uint32_t width_px, std::uint32_t height_px,
                      double horizontal_field_of_view_rad, double near_m) {
    const glm::dmat3 axes = axes_of(pose);
    terrain::View view;
    view.eye = earth::to_ecef(pose.position);
    view.forward = axes[0];
    view.right = axes[1];
    view.down = axes[2];
    view.width = width_px;
    view.height = height_px;
    view.focal_px = 0.5 * width_px / std::tan(0.5 * horizontal_field_of_view_rad);
    view.near_m = near_m;
    return view;
}

void FreeCamera::place(const CameraPose& pose) {
    pose_ = pose;
    pose_.roll_rad = 0;
    look(0, 0);
}

void FreeCamera::look(double right_rad, double up_rad) {
    pose_.heading_rad = earth::wrap_heading(pose_.heading_rad + right_rad);
    pose_.pitch_rad = std::clamp(pose_.pitch_rad + up_rad, -kSteepestPitch_rad, kSteepestPitch_rad);
}

void FreeCamera::fly(const CameraMotion& motion, base::Duration wall) {
    if (!motion.any()) return;
    const glm::dmat3 axes = axes_of(pose_);
    const glm::dvec3 up = -earth::north_east_down(pose_.position.latitude_rad, pose_.position.longitude_rad)[2];
    const glm::dvec3 velocity = speed_mps_ * (static_cast<double>(motion.forward) * axes[0] +
                                              static_cast<double>(motion.right) * axes[1] + static_cast<double>(motion.up) * up);
    pose_.position = earth::from_ecef(earth::to_ecef(pose_.position) + velocity * wall.to_seconds());
    pose_.position.height.m = std::clamp(pose_.position.height.m, kLowest_m, kHighest_m);
}

void FreeCamera::change_speed(int notches) {
    speed_mps_ = std::clamp(speed_mps_ * std::pow(kNotch, notches), kSlowest_mps, kFastest_mps);
}

}  // namespace tedavis::host_sim
