/// Two runs of the same flight, frame by frame.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/evaluation/evaluated_flight.hpp"

namespace tedavis::host_sim {

/// Differences over the frames of one phase of the first run, or over all frames.
struct PhaseDifference {
    std::string phase;
    double begin_s = 0, end_s = 0;
    std::size_t frames = 0;
    double mean_a = 0, mean_b = 0, highest_a = 0, highest_b = 0;
};

struct FlightComparison {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< indices of frames of the same time, in its order
    std::size_t only_a = 0, only_b = 0;                      ///< frames that the other run lacks
    std::vector<PhaseDifference> phases;
    PhaseDifference all;
    std::string name_a, name_b;  ///< names that distinguish the runs: their designs, else their folders
};

/// Pairs frames whose times differ by less than a millisecond. Throws UserError where there are none.
[[nodiscard]] FlightComparison compared(const EvaluatedFlight& a, const EvaluatedFlight& b);

/// The frame nearest in time.
[[nodiscard]] std::size_t frame_nearest(const EvaluatedFlight& flight, double time_s);

}  // namespace tedavis::host_sim
