/// What an [[expect]] table asks of a frame.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads phase, phase_source, design, flags, no_flags, signals, effects, values, alert, obstacle_alert,
/// latency_frames_at_most, text and contract. A table without any of them is a fault.
[[nodiscard]] std::vector<FrameCondition> read_conditions(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults);

/// The flags of a record, which say why something is shown.
[[nodiscard]] std::string list_of_flags(const display::FrameRecord& record);
/// Why the phase is what it is.
[[nodiscard]] std::string words_of_phase(const flight::PhaseStatus& status);
/// All names of flags that a record can have.
[[nodiscard]] std::vector<std::string> record_flag_names();
/// "approach.final", or the scenario alone where no sub-phase is stated.
[[nodiscard]] std::string phase_text(flight::FlightPhase phase);
/// "none", "caution" or "warning" of terrain, and of obstacles; "not_watching" where there could be none.
[[nodiscard]] std::string alert_text(const ObservedFrame& frame);
[[nodiscard]] std::string obstacle_alert_text(const ObservedFrame& frame);
/// What an expectation writes after a scenario's name for none of its sub-phases.
inline constexpr const char* kNoSubPhase = ".none";
/// As phase_text(), but "approach.none" where the scenario has sub-phases and none is stated: it expects this phase alone.
[[nodiscard]] std::string exact_phase_text(flight::FlightPhase phase);
/// All phases that can be stated.
[[nodiscard]] std::vector<std::string> phase_names();

}  // namespace tedavis::host_sim
