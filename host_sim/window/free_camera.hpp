/// An eye that flies anywhere: moved by keys, turned by the mouse. Pure: time comes in as durations.
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

/// What the camera sees on a picture of this size; `near_m` to the nearest terrain that is drawn.
[[nodiscard]] terrain::View view_of(const CameraPose& pose, std::uint32_t width_px, std::uint32_t height_px,
                                    double horizontal_field_of_view_rad, double near_m);

/// Each -1, 0 or 1: along the view, to its right, and straight up.
struct CameraMotion {
    int forward = 0, right = 0, up = 0;
    [[nodiscard]] bool any() const { return forward != 0 || right != 0 || up != 0; }
};

class FreeCamera {
public:
    /// Takes over a pose, level.
    void place(const CameraPose& pose);
    /// Right and up positive; the pitch stays within 89 degrees.
    void look(double right_rad, double up_rad);
    void fly(const CameraMotion& motion, base::Duration wall);
    /// A notch is a quarter more or less, within 1 .. 50,000 m/s.
    void change_speed(int notches);

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    [[nodiscard]] double speed_mps() const { return speed_mps_; }

private:
    CameraPose pose_;
    double speed_mps_ = 200;
};

}  // namespace tedavis::host_sim
