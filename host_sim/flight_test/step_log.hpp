/// The steps of a flight test as the logs that a replay reads: a candump log of the bus, and a switch log of the panel.
#pragma once

#include <ostream>
#include <string>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// Writes the bus from 0 to end_s: each signal at its message's period, the clock and the stated phase each second and on change,
/// and the frames of the steps. The first and the last millisecond always have a frame, if necessary one without a meaning, so
/// that the log begins and ends there. Throws UserError where a value cannot be sent, with its step's line, or the stream fails.
void write_step_log(const FlightTest& test, std::ostream& stream, const std::string& name);

/// Returns the switch log of the panel's edges; empty where no step changes a line. Before the first edge the panel has its
/// resting_levels() (timed_input.hpp).
[[nodiscard]] std::string step_switch_log(const FlightTest& test);

}  // namespace tedavis::host_sim
