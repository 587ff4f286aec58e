/// How much of the window the display draws: its size, and its pictures a second.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_picture_size_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_output_rate_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
