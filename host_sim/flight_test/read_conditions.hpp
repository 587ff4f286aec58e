/// Reads the conditions of an [[expect]] table.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads phase, phase_source, design, flags, no_flags, signals, effects, elements, values, alert, obstacle_alert,
/// latency_frames_at_most, text and contract. A table without any of them is a fault.
[[nodiscard]] std::vector<FrameCondition> read_conditions(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults);

/// The names of a record's flags, for a message.
[[nodiscard]] std::string list_of_flags(const display::FrameRecord& record);
/// The phase, its source, and faults of the sources, for a message.
[[nodiscard]] std::string words_of_phase(const flight::PhaseStatus& status);
/// All names of flags that a record can have.
[[nodiscard]] std::vector<std::string> record_flag_names();
/// "approach.final", or the scenario alone where no sub-phase is stated.
[[nodiscard]] std::string phase_text(flight::FlightPhase phase);
/// "none", "caution" or "warning" for terrain, and for obstacles; "not_watching" where no alert is possible.
[[nodiscard]] std::string alert_text(const ObservedFrame& frame);
[[nodiscard]] std::string obstacle_alert_text(const ObservedFrame& frame);
/// Suffix of a scenario's name in an expectation of no sub-phase.
inline constexpr const char* kNoSubPhase = ".none";
/// What an expectation of no_flags has before a flag's name.
inline constexpr const char* kNoFlag = "no ";
/// As phase_text(), but "approach.none" where the scenario has sub-phases and none is stated. As an expectation, "approach" also
/// holds in its sub-phases, "approach.none" does not.
[[nodiscard]] std::string exact_phase_text(flight::FlightPhase phase);
/// All phases that can be stated.
[[nodiscard]] std::vector<std::string> phase_names();

}  // namespace tedavis::host_sim
