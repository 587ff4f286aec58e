/// Two settings of the approximate searches for the hit of a ray: how many steps a ray takes, and how often the step of the hit
/// is halved (render_core/raytrace/search/uniform_search.hpp; the thesis's tracer, 6.2.2.2).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

/// Steps along the whole ray. What a step passes over is not found, so this is the control that lands visibly wrong.
[[nodiscard]] std::unique_ptr<Knob> make_ray_steps_knob(const KnobGround& ground);
/// Halvings of a step within a cell, of rays that find the exact tracer's hit.
[[nodiscard]] std::unique_ptr<Knob> make_ray_halvings_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
