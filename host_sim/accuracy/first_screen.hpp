/// The first screen of the report: the most accurate settings within a frame's time, the cost of the next level, and the error
/// that remains.
///
/// Its answers come from the knob whose levels are combinations of a picture's settings (frame_settings). If the report lacks
/// this knob, the screen states that it was not measured.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// HTML: a sentence, three numbers, and a table with a row for each budget.
[[nodiscard]] std::string first_screen(const AccuracyReport& report);

}  // namespace tedavis::host_sim
