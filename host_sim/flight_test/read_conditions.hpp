/// What an [[expect]] table asks of a frame.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads phase, phase_source, design, flags, no_flags, signals, effects, values, alert, obstacle_alert,
/// latency_frames_at_most and text.
/// A table without any of them is a fault. `designs` are the names that a frame's design can have.
[[nodiscard]] std::vector<FrameCondition> read_conditions(ScriptTable& table, const std::vector<std::string>& designs,
                                                          ScriptFaults& faults);

/// All names of flags that a record can have.
[[nodiscard]] std::vector<std::string> record_flag_names();
/// "approach.final", or the scenario alone where no sub-phase is stated.
[[nodiscard]] std::string phase_text(flight::FlightPhase phase);
/// All phases that can be stated.
[[nodiscard]] std::vector<std::string> phase_names();

}  // namespace tedavis::host_sim
