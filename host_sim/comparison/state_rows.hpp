/// Rows of colored spans over a common axis, as inline SVG: phases and alerts of two runs below each other.
#pragma once

#include <string>
#include <vector>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {

struct StateRow {
    std::string name;              ///< label to the left of the row
    std::vector<ChartSpan> spans;  ///< in the units of the axis
};

/// Returns an SVG that scales with its container. The axis is from `low` to `high`, with `low` < `high`.
[[nodiscard]] std::string state_rows_svg(const std::string& title, const std::vector<StateRow>& rows, double low, double high,
                                         const std::string& unit);

}  // namespace tedavis::host_sim
