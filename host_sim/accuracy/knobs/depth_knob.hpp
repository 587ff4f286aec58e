/// The number format of a depth buffer, and the depth ranges for which it is used (render_core/draw/depth_plan.hpp), a setting
/// with one level.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_depth_format_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
