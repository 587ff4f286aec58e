/// Two settings of the approximate searches for the hit of a ray: how many steps a ray takes, and how often the step of the hit
/// is halved (render_core/raytrace/search/uniform_search.hpp; the thesis's tracer, 6.2.2.2).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

/// Number of steps along the whole ray. A hit between two steps may be missed.
[[nodiscard]] std::unique_ptr<Knob> make_ray_steps_knob(const KnobGround& ground);
/// The same setting with two levels: far too few steps, which must land visibly wrong, and enough. It is not in the registry:
/// with it the report proves that it would show a wrong level (accuracy/negative_control.hpp).
[[nodiscard]] std::unique_ptr<Knob> make_ray_control(const KnobGround& ground);
/// Number of halvings of a step within a cell, for rays whose hit is that of the exact tracer.
[[nodiscard]] std::unique_ptr<Knob> make_ray_halvings_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
