/// A report for people, as plain text: a table a knob, its laws, and what its next level costs.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string accuracy_text(const AccuracyReport& report);
/// "the most accurate within 12 ms: 16 steps (3.1 ms, at most 0.2 cells); ...", a line a knob, with the margin. Throws UserError
/// where no level of any knob keeps to it.
[[nodiscard]] std::string budget_text(const AccuracyReport& report, double budget_ms);
/// Of the knobs with this unit; throws UserError, which begins with `option`, where no knob has it.
[[nodiscard]] std::string target_text(const AccuracyReport& report, double target_error, const std::string& unit,
                                      const std::string& option);

}  // namespace tedavis::host_sim
