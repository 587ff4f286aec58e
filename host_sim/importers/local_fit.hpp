/// Local least-squares parabolas through a series: values and slopes of noisy samples at uneven times (Savitzky and
/// Golay, "Smoothing and differentiation of data", Analytical Chemistry 36, 1964, without the even spacing).
#pragma once

#include <vector>

namespace tedavis::host_sim {

struct FittedSeries {
    std::vector<double> values;
    std::vector<double> slopes;  ///< per second
};

/// Fits at each sample those within `half_window_s` of it and always one neighbour on either side. Times rise strictly.
/// Fewer than three samples give the samples themselves and their difference quotient.
[[nodiscard]] FittedSeries fit_locally(const std::vector<double>& times_s, const std::vector<double>& values,
                                       double half_window_s);

}  // namespace tedavis::host_sim
