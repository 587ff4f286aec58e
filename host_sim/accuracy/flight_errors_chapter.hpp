/// The chapter of the report on the terrain's error: what was asked for, proven and measured, by tolerance and along the flight.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/flight_errors.hpp"

namespace tedavis::host_sim {

/// HTML: a chart of all flights over the tolerance, and for each flight a table with the same figures and charts over the time.
/// There is at least one flight.
[[nodiscard]] std::string flight_errors_chapter(const std::vector<FlightErrors>& flights);

/// SVG, both axes logarithmic: over the tolerance what was asked for, and two lines for each flight, told apart by dashes as well
/// as by colours; flights are told apart by marks. Below it stands how tight the bound of each is.
[[nodiscard]] std::string tolerance_chart_svg(const std::vector<FlightErrors>& flights);

/// A line for each tolerance of each flight.
[[nodiscard]] std::string flight_errors_text(const std::vector<FlightErrors>& flights);

}  // namespace tedavis::host_sim
