/// The key `text` of an [[expect]] table.
///
/// A text that must be there is judged twice: the frame's symbology writes it, and the pixels of its picture show it, so that
/// one that another thing covers is found (text_in_pixels.hpp). One that must not be there is not written. A frame without a
/// picture is judged by what it writes.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads text = { says = "TERRAIN AHEAD", in = "annunciations", there = true }, or a list of such, where the table has it.
void read_text_conditions(ScriptTable& table, ScriptFaults& faults, std::vector<FrameCondition>& conditions);

}  // namespace tedavis::host_sim
