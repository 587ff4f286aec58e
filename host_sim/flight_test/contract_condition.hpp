/// The key `contract` of an [[expect]] table: the conditions of a perceptual contract (host_sim/contract), which the picture of
/// a frame must meet.
///
/// They are measured in the drawn picture and its layers, as `tedavis contract` measures a run. A condition is judged in its
/// phases alone. Where it has nothing to measure, it is broken unless it is optional; a frame in which nothing was measured does
/// not meet the contract. With WindowKind::during, a limit is broken only if it is exceeded for `for_s`, as in a run; with the
/// other kinds, in the first frame that exceeds it.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads contract = "approach" (a shipped contract or a file), where the table has the key, and appends to `conditions`, which
/// holds those of the keys read before. Faults are a contract that cannot be read, one without a condition for the phase that the
/// table expects, and a condition, not optional, that needs the data of a scene where the script has none.
void read_contract_condition(ScriptTable& table, const PictureOptions& picture, std::vector<FrameCondition>& conditions);

}  // namespace tedavis::host_sim
