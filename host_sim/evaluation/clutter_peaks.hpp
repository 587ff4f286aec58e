/// Finds the peaks of a curve over time by their prominence.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

struct Peak {
    std::size_t index = 0;
    double prominence = 0;  ///< down to the higher of the two valleys that part it from higher ground, or from the curve's ends
};

struct PeakRule {
    double least_prominence = 0;  ///< in the curve's unit
    double least_distance_s = 0;  ///< of two peaks; the higher one stays, of equal ones the earlier
    std::size_t most = 6;         ///< the most prominent ones stay
};

/// What reports use: a peak rises by a seventh of the curve's range, at least 0.005, and stands a thirtieth of the flight from
/// others, at least 3 s.
[[nodiscard]] PeakRule peak_rule_for(const std::vector<double>& times_s, const std::vector<double>& values);

/// In the order of time, which rises. Of a plateau its middle; both ends of the curve may be peaks. A flat curve has none.
[[nodiscard]] std::vector<Peak> find_peaks(const std::vector<double>& times_s, const std::vector<double>& values,
                                           const PeakRule& rule);

}  // namespace tedavis::host_sim
