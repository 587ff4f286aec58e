/// Finds the peaks of a curve over time by their prominence.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

struct Peak {
    std::size_t index = 0;
    /// Height above the higher of the two lowest points between it and higher values, or the curve's ends, on either side.
    double prominence = 0;
};

struct PeakRule {
    double least_prominence = 0;  ///< in the curve's unit
    double least_distance_s = 0;  ///< between two peaks; the higher one is kept, of equal ones the earlier
    std::size_t most = 6;         ///< largest number of peaks; the most prominent ones are kept
};

/// Returns the rule of the reports: a prominence of at least a seventh of the curve's range and 0.005, and a distance between
/// peaks of at least a thirtieth of the flight and 3 s.
[[nodiscard]] PeakRule peak_rule_for(const std::vector<double>& times_s, const std::vector<double>& values);

/// Returns the peaks, ascending in time; `times_s` must ascend. A plateau is a peak at its middle; both ends of the curve may be
/// peaks. A flat curve has none.
[[nodiscard]] std::vector<Peak> find_peaks(const std::vector<double>& times_s, const std::vector<double>& values,
                                           const PeakRule& rule);

}  // namespace tedavis::host_sim
