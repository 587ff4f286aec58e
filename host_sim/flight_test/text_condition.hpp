/// The key `text` of an [[expect]] table.
///
/// A text that must be there is judged twice: by the symbology of the planned frame, and by the pixels of its picture, so that a
/// covered text fails (text_in_pixels.hpp). A text that must not be there is judged by the symbology, as are all texts of a frame
/// without a picture.
#pragma once

#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_table.hpp"

namespace tedavis::host_sim {

/// Reads text = { says = "TERRAIN AHEAD", in = "annunciations", there = true }, or a list of such tables, if the table has the
/// key.
void read_text_conditions(ScriptTable& table, ScriptFaults& faults, std::vector<FrameCondition>& conditions);

}  // namespace tedavis::host_sim
