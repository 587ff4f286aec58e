/// The levels of quality by which the governor holds a frame's deadline (render_core/effects/quality_level.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_quality_level_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
