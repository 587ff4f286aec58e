/// `report.html` of `tedavis accuracy`: one self-contained file, readable on a phone and on paper.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// Returns a summary, then one section for each knob (a setting that trades accuracy for time): its error and reference, a chart,
/// a table of its levels, the power laws fitted to error and time, and the cost of the next level.
[[nodiscard]] std::string accuracy_page(const AccuracyReport& report);

}  // namespace tedavis::host_sim
