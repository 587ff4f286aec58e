/// The first screen of the report: the best that a frame's time buys, what the next level costs, and what is lost.
///
/// It answers from the knob whose levels are combinations of a picture's settings (frame_settings); without that knob in the
/// report it says that it was not measured.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"
#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"

namespace tedavis::host_sim {

/// The most accurate level of whose slowest place 95 of 100 frames keep to the budget; null if none does.
[[nodiscard]] const MeasuredLevel* best_frame_within(const MeasuredKnob& knob, double budget_ms);

/// HTML: a sentence, three numbers, and a table with a row for each budget.
[[nodiscard]] std::string first_screen(const AccuracyReport& report);

}  // namespace tedavis::host_sim
