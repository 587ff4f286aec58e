/// Returns the report as plain text: for each knob a table, its power laws, and the cost of its next level.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string accuracy_text(const AccuracyReport& report);
/// Returns one line per knob with its most accurate level within a time budget and the margin: "the most accurate within 12 ms:
/// 16 steps (3.1 ms, at most 0.2 cells); ...". Throws UserError where no level of any knob is within the budget.
[[nodiscard]] std::string budget_text(const AccuracyReport& report, double budget_ms);
/// Returns the quickest levels within a target error, for the knobs whose errors have this unit. Throws UserError, whose message
/// begins with `option`, where no knob has it.
[[nodiscard]] std::string target_text(const AccuracyReport& report, double target_error, const std::string& unit,
                                      const std::string& option);

}  // namespace tedavis::host_sim
