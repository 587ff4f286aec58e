/// What the next more accurate level of a knob costs.
#pragma once

#include <vector>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct NextLevel {
    const MeasuredLevel *from = nullptr, *to = nullptr;
    double error_ratio = 0;  ///< mean error of `to` divided by that of `from`; below 1
    double time_ratio = 0;   ///< ratio of the median times
    double more_bytes = 0;   ///< additional memory of `to`; negative if it takes less
};

/// Returns the steps from each level that is not dominated to the next slower one; none for a knob with one level. The knob must
/// outlive the result.
[[nodiscard]] std::vector<NextLevel> next_levels(const MeasuredKnob& knob);

}  // namespace tedavis::host_sim
