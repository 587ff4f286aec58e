/// Reads an [[expect]] table: its window of time and its conditions.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads at_s, from_s with to_s, or within_s after after_s with `stays`; the conditions (read_conditions.hpp); and `name`, whose
/// default is words_of_expectation().
[[nodiscard]] Expectation read_expectation(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults);

/// "3 s: phase cruise, phase_source can".
[[nodiscard]] std::string words_of_expectation(const Expectation& expectation);

/// Expectations that no frame can meet together are faults: one key with two values at one time, a signal or an effect in two
/// states, a flag or a text that must be there and must not, a value of a signal that has none, ranges without a common value, a
/// phase and a source that cannot state it.
void find_contradictions(const std::vector<Expectation>& expectations, ScriptFaults& faults);

}  // namespace tedavis::host_sim
