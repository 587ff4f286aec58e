/// What something costs, from times of frames with and without it that were drawn in turn: drifts of the machine meet both alike.
#pragma once

#include <vector>

namespace tedavis::host_sim {

struct PairedCost {
    double ms = 0;         ///< median of the pairs' differences, at least 0
    double spread_ms = 0;  ///< half of the distance between their quartiles
};

/// The n-th of both are a pair; at least one.
[[nodiscard]] PairedCost paired_cost(const std::vector<double>& with_ms, const std::vector<double>& without_ms);

/// Mean of the middle two; 0 for none.
[[nodiscard]] double median_of(std::vector<double> values);

struct CostSlope {
    double offset = 0;
    double slope = 0;  ///< at least 0
};
struct CostPoint {
    double things = 0, ms = 0;
};
/// Least squares; where all have the same number of things, their mean as offset.
[[nodiscard]] CostSlope cost_slope(const std::vector<CostPoint>& points);

}  // namespace tedavis::host_sim
