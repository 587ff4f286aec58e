/// An [[expect]] table: when, and what.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads at_s, from_s with to_s, or within_s after after_s with `stays`; the conditions (read_conditions.hpp); and `name`, whose
/// default says them in words.
[[nodiscard]] Expectation read_expectation(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults);

/// "3 s: phase cruise, phase_source can".
[[nodiscard]] std::string words_of_expectation(const Expectation& expectation);

/// Expectations that no frame can meet together are faults: one key with two values at one time, a signal or an effect in two
/// states, a flag or a text that must be there and must not.
void find_contradictions(const std::vector<Expectation>& expectations, ScriptFaults& faults);

}  // namespace tedavis::host_sim
