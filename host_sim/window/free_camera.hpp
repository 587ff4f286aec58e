/// A camera that moves freely: keys move it, the mouse turns it. Pure: the caller passes the elapsed time.
#pragma once

#include "render_core/base/time.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::host_sim {

/// Heading true, clockwise from north; pitch nose up, roll right wing down positive.
struct CameraPose {
    earth::Geodetic position;
    double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
};

/// Returns the view of the camera in a picture of this size; `near_m` is the distance of the near plane.
[[nodiscard]] terrain::View view_of(const CameraPose& pose, std::uint32_t width_px, std::uint32_t height_px,
                                    double horizontal_field_of_view_rad, double near_m);

/// Directions of motion, each -1, 0 or 1: along the view, to its right, and straight up.
struct CameraMotion {
    int forward = 0, right = 0, up = 0;
    [[nodiscard]] bool any() const { return forward != 0 || right != 0 || up != 0; }
};

class FreeCamera {
public:
    /// Sets the pose, with roll 0.
    void place(const CameraPose& pose);
    /// Right and up positive; the pitch stays within 89 degrees.
    void look(double right_rad, double up_rad);
    void fly(const CameraMotion& motion, base::Duration wall);
    /// Changes the speed by a quarter per notch, within 1 .. 50,000 m/s.
    void change_speed(int notches);

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    [[nodiscard]] double speed_mps() const { return speed_mps_; }

private:
    CameraPose pose_;
    double speed_mps_ = 200;
};

}  // namespace tedavis::host_sim
