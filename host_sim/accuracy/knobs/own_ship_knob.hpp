/// Settings of the filter that estimates the own ship's position from messages, from holding the last position to smoothing
/// (bus/state/own_ship_filter.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_own_ship_filter_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
