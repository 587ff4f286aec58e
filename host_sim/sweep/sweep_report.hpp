/// `report.html` of a sweep: what stands out, and a table of small pictures, a ring of viewpoints a row. One self-contained file,
/// readable on a phone and on paper.
#pragma once

#include <string>

#include "host_sim/sweep/swept_views.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string sweep_report_page(const Sweep& sweep);

}  // namespace tedavis::host_sim
