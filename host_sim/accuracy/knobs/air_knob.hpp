/// The number of steps along a ray in which in-scattered light and extinction of the air are summed
/// (render_core/earth/atmosphere.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "render_core/earth/atmosphere.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_air_steps_knob(const KnobGround& ground);

/// A ray through the air to an end above the ground.
struct AirRay {
    double eye_height_m = 0, sine = 0, length_m = 0;
};

/// The knob's reference: the air's effect along a ray by midpoints in long double, at places in space, in `steps` steps that
/// grow with the distance. Sunlight is that of `sun` at every height.
[[nodiscard]] earth::AirLight air_by_midpoints(const earth::Air& air, const earth::SunThroughAir& sun, const AirRay& ray,
                                               int steps);

}  // namespace tedavis::host_sim
