/// The section of report.html on the run's closest points to the terrain, with the profile of its flight.
#pragma once

#include <string>

#include "host_sim/reports/closest_json.hpp"

namespace tedavis::host_sim {

/// "It came within 312 ft (95 m ± 24 m, 95 %) of the ground at 14:23:05.2 UTC at 46.7312 N 9.8123 E, in cruise; ...". States why
/// where there is no closest point. Plain text, not HTML.
[[nodiscard]] std::string closest_sentence(const ClosestReport& report);

/// Returns sentence, tables and profile as HTML without a heading; empty where is_searched is false.
[[nodiscard]] std::string closest_html(const ClosestReport& report);

}  // namespace tedavis::host_sim
