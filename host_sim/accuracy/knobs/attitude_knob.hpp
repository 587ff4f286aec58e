/// The attitude between two that are given (`replay --window --tour`), a setting with one level.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_attitude_between_knob(const KnobGround& ground);

/// As earth::body_axes() takes them.
struct Attitude {
    double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
};

/// The knob's reference: the body's axes in north, east and down after a share, 0..1, of the shortest turn at a constant rate,
/// in long double (K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985).
[[nodiscard]] glm::dmat3 axes_by_long_slerp(const Attitude& from, const Attitude& to, double share);

}  // namespace tedavis::host_sim
