/// The chapter of the report on the terrain's error: requested, proven and measured, by tolerance and along the flight.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/flight_errors.hpp"

namespace tedavis::host_sim {

/// HTML: a chart of all flights over the tolerance, and for each flight a table with the same figures and charts over the time.
/// There is at least one flight.
[[nodiscard]] std::string flight_errors_chapter(const std::vector<FlightErrors>& flights);

/// Returns an SVG with logarithmic axes: over the tolerance, the requested error and two lines for each flight, which differ by
/// dashes as well as by colours; flights differ by marks. The tightness of each flight's bound is stated below.
[[nodiscard]] std::string tolerance_chart_svg(const std::vector<FlightErrors>& flights);

/// A line for each tolerance of each flight.
[[nodiscard]] std::string flight_errors_text(const std::vector<FlightErrors>& flights);

}  // namespace tedavis::host_sim
