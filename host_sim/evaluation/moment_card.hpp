/// A moment of a flight on the report's page: the picture, its saliency, and the frame's plan.
#pragma once

#include <string>

#include "host_sim/evaluation/evaluated_flight.hpp"

namespace tedavis::host_sim {

/// Returns "moment-A", the target of links.
[[nodiscard]] std::string moment_id(const FlightMoment& moment);
/// "A: 312.0 s, approach.final, clutter 0.21"
[[nodiscard]] std::string moment_words(const EvaluatedFlight& flight, const FlightMoment& moment);
/// A link for the list below the graph.
[[nodiscard]] std::string moment_tab(const EvaluatedFlight& flight, const FlightMoment& moment);
/// A flight with the name that distinguishes it from the other one.
struct ComparedFlight {
    const EvaluatedFlight* flight = nullptr;
    std::string name;
};
[[nodiscard]] std::string moment_card(const ComparedFlight& own, const FlightMoment& moment, const ComparedFlight& other,
                                      const EvaluationSettings& settings);

}  // namespace tedavis::host_sim
