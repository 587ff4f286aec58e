/// The phase switches of a scenario: the pilot's settings as a switch log.
#pragma once

#include <string>

#include "bus/switches/switch_config.hpp"
#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_flight.hpp"

namespace tedavis::host_sim {

/// Returns the log's text: levels of all lines at the start, then one change for each leg whose phase the panel states; on the
/// other legs the panel has its pattern for "unknown". During a change (18 ms) neither contact is closed. Throws UserError where
/// the panel has no pattern for a leg's phase or its scenario, or none for "unknown".
[[nodiscard]] std::string scenario_switch_log(const Scenario& scenario, const ScenarioFlight& flight,
                                              const bus::SwitchConfig& config);

}  // namespace tedavis::host_sim
