/// What something costs, from times of frames with and without it that were drawn in turn: drifts of the machine meet both alike.
///
/// Pure. Thread  any. Memory  none: the caller gives the room in which times are sorted, as long as the longest list of them.
#pragma once

#include "render_core/base/span.hpp"

namespace tedavis::effects {

struct PairedCost {
    double ms = 0;         ///< median of the pairs' differences, at least 0
    double spread_ms = 0;  ///< half of the distance between their quartiles
};

/// The n-th times of both are a pair; what one of the two has more is left out.
[[nodiscard]] PairedCost paired_cost(base::Span<const double> with_ms, base::Span<const double> without_ms,
                                     base::Span<double> room);

/// Mean of the middle two; 0 for none.
[[nodiscard]] double median_of(base::Span<const double> values, base::Span<double> room);

struct CostSlope {
    double offset = 0;
    double slope = 0;  ///< at least 0
};
struct CostPoint {
    double things = 0, ms = 0;
};
/// Least squares; where all have the same number of things, their mean as offset.
[[nodiscard]] CostSlope cost_slope(base::Span<const CostPoint> points);

}  // namespace tedavis::effects
