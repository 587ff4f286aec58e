/// The steps of a flight test as the logs that a replay reads: a candump log of the bus, and a switch log of the panel.
#pragma once

#include <ostream>
#include <string>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// Writes the bus from 0 to end_s: each signal at its message's period, the clock and a phase that is stated each second and on
/// change, and the frames of the steps. The first and the last millisecond always have a frame, if need be one that means
/// nothing, so that the log begins and ends there. Throws UserError where a value cannot be sent, with its step's line, or the
/// stream fails.
void write_step_log(const FlightTest& test, std::ostream& stream, const std::string& name);

/// The panel's edges; empty where no step throws a switch. Before the first of them the panel leaves the phase to the other
/// sources, where it has a pattern for that; else no line is active.
[[nodiscard]] std::string step_switch_log(const FlightTest& test);

}  // namespace tedavis::host_sim
