/// The part of report.html that says where the run came closest to the terrain, and the profile of its flight.
#pragma once

#include <string>

#include "host_sim/reports/closest_json.hpp"

namespace tedavis::host_sim {

/// "It came within 312 ft (95 m ± 24 m, 95 %) of the ground at 14:23:05.2 UTC at 46.7312 N 9.8123 E, in cruise; ...". Says why
/// there is none where nothing was found. As text, not HTML.
[[nodiscard]] std::string closest_sentence(const ClosestReport& report);

/// Sentence, tables and profile as HTML without a heading; empty where it was not searched.
[[nodiscard]] std::string closest_html(const ClosestReport& report);

}  // namespace tedavis::host_sim
