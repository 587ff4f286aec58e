/// `report.html` of an evaluated flight, or of two designs over the same flight: clutter over time with phases below it (as in
/// the thesis, Figure 5.22), the peaks with their pictures, saliency by layer, tables. One self-contained file: pictures as
/// data URIs, the graph as inline SVG; readable without scripts, on a phone and on paper.
#pragma once

#include <string>
#include <vector>

#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/evaluation/flight_comparison.hpp"

namespace tedavis::host_sim {

struct FlightReport {
    EvaluationSettings settings;
    std::vector<EvaluatedFlight> flights;        ///< one, or the two that are compared
    std::optional<FlightComparison> comparison;  ///< of two
};

[[nodiscard]] std::string flight_report_page(const FlightReport& report);

}  // namespace tedavis::host_sim
