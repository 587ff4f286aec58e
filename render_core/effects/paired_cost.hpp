/// The cost of an effect, from times of frames with and without it that were drawn alternately, so that drifts of the machine's
/// speed affect both equally.
///
/// Pure. Thread  any. Memory  none: the caller provides `room`, in which times are sorted; it is as long as the longest list.
#pragma once

#include "render_core/base/span.hpp"

namespace tedavis::effects {

struct PairedCost {
    double ms = 0;         ///< median of the pairs' differences, at least 0
    double spread_ms = 0;  ///< half of the distance between their quartiles
};

/// Returns the cost. The n-th times of both lists are a pair; surplus times of the longer list are ignored.
[[nodiscard]] PairedCost paired_cost(base::Span<const double> with_ms, base::Span<const double> without_ms,
                                     base::Span<double> room);

/// Returns the median: the middle value, or the mean of the middle two; 0 for no values.
[[nodiscard]] double median_of(base::Span<const double> values, base::Span<double> room);

struct CostSlope {
    double offset = 0;  ///< ms
    double slope = 0;   ///< ms per thing, at least 0
};
struct CostPoint {
    double things = 0, ms = 0;
};
/// Returns the line of least squares; where all points have the same number of things, the offset is the mean time.
[[nodiscard]] CostSlope cost_slope(base::Span<const CostPoint> points);

}  // namespace tedavis::effects
