/// `report.html` of `tedavis accuracy`: one file that needs nothing but itself, readable on a phone and on paper.
#pragma once

#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// A summary, then a section a knob: its chart, its levels, its laws, what the next level costs, what it is measured against.
[[nodiscard]] std::string accuracy_page(const AccuracyReport& report);

}  // namespace tedavis::host_sim
