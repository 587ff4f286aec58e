/// The steps of a flight test, and where its aircraft starts.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Latest time of a step or an expectation, s.
inline constexpr double kLatestTestTime_s = 7200;

/// Reads [start]. Absent keys have the values of an aircraft in level flight, or standing, over the shipped terrain.
[[nodiscard]] TestStart read_start(ScriptTable& table);

/// Reads a [[step]]. Faults are signals that `bus` sends in messages of its own, lines that `panel` does not have, and unknown
/// phases. A panel without lines is one that could not be read: names of its lines are not checked.
[[nodiscard]] TestStep read_step(ScriptTable& table, const bus::BusSettings& bus, const bus::SwitchConfig& panel,
                                 ScriptFaults& faults);

/// Names of all lines of a panel, as in the key "panel.GROUND".
[[nodiscard]] std::vector<std::string> panel_line_names(const bus::SwitchConfig& panel);

}  // namespace tedavis::host_sim
