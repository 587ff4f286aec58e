/// The first screen of the report: the best that a frame's time buys, what the next level costs, and what is lost.
///
/// It answers from the knob whose levels are combinations of a picture's settings (frame_settings); without that knob in the
/// report it says that it was not measured.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// HTML: a sentence, three numbers, and a table with a row for each budget.
[[nodiscard]] std::string first_screen(const AccuracyReport& report);

}  // namespace tedavis::host_sim
