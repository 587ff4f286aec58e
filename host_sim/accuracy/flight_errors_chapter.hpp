/// The chapter of the report on the terrain's error: what was asked for, proven and measured, by tolerance and along the flight.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/flight_errors.hpp"

namespace tedavis::host_sim {

/// HTML: for each flight a chart over the tolerance, a table with the same figures, and charts over the time.
[[nodiscard]] std::string flight_errors_chapter(const std::vector<FlightErrors>& flights);

/// SVG, both axes logarithmic: three lines over the tolerance, told apart by marks as well as by colours.
[[nodiscard]] std::string tolerance_chart_svg(const FlightErrors& flight);

/// A line for each tolerance of each flight.
[[nodiscard]] std::string flight_errors_text(const std::vector<FlightErrors>& flights);

}  // namespace tedavis::host_sim
