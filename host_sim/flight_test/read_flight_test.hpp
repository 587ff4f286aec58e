/// Reads a flight test's file with those that it includes.
#pragma once

#include <string>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_value.hpp"

namespace tedavis::host_sim {

/// `stated` are parameters of the command line: they come before those of the files. All faults are added to `faults`; with some,
/// the test must not be run. Throws UserError where the file itself cannot be read.
[[nodiscard]] FlightTest read_flight_test(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults);

}  // namespace tedavis::host_sim
