/// Rows of colored spans over a common axis, as inline SVG: phases and alerts of two runs below each other.
#pragma once

#include <string>
#include <vector>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {

struct StateRow {
    std::string name;              ///< stands to the left of it
    std::vector<ChartSpan> spans;  ///< in the units of the axis
};

/// Scales with its container. `low` to `high`: the axis, not empty.
[[nodiscard]] std::string state_rows_svg(const std::string& title, const std::vector<StateRow>& rows, double low, double high,
                                         const std::string& unit);

}  // namespace tedavis::host_sim
