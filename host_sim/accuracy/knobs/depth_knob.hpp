/// The numbers in which a depth buffer keeps depths, and the ranges that it is used for (render_core/draw/depth_plan.hpp), a
/// setting with one level.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_depth_format_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
