/// The key `contract` of an [[expect]] table: the conditions of a perceptual contract (host_sim/contract), which the picture of
/// a frame must meet.
///
/// They are measured as `tedavis contract` measures a run, of the picture that is drawn and of its layers. A condition counts in
/// its phases. One that has nothing to measure counts as beyond its limit unless it is optional, and a frame in which nothing
/// was measured does not meet the contract. In every frame of a span (WindowKind::during) `for_s` counts as in a run; a single
/// frame, and one that must be reached, is beyond the limit at once.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads contract = "approach", a shipped one or a file, where the table has it; `conditions` are those that were read before. A
/// fault is a contract that cannot be read, one without a condition for the phase that the table asks for, and a condition that
/// needs the data of a scene where the script has none, unless it is optional.
void read_contract_condition(ScriptTable& table, const PictureOptions& picture, std::vector<FrameCondition>& conditions);

}  // namespace tedavis::host_sim
