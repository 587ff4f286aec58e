/// A smooth curve through samples that never leaves the range of its two neighbours (Fritsch and Carlson, "Monotone
/// piecewise cubic interpolation", SIAM J. Numerical Analysis 17, 1980; slopes after Brodlie).
#pragma once

#include <vector>

namespace tedavis::host_sim {

class MonotoneCurve {
public:
    MonotoneCurve() = default;
    /// Times rise strictly; at least one sample. One sample is a constant.
    MonotoneCurve(std::vector<double> times_s, std::vector<double> values);

    /// Before the first and after the last sample it returns their values.
    [[nodiscard]] double at(double time_s) const;
    /// Whether samples lie on either side of the time and no further apart than this.
    [[nodiscard]] bool covers(double time_s, double longest_gap_s) const;
    [[nodiscard]] std::size_t size() const { return times_.size(); }
    [[nodiscard]] bool empty() const { return times_.empty(); }

private:
    std::vector<double> times_, values_, slopes_;
};

/// Index i with times[i] <= time < times[i + 1], clamped to [0, size - 2]; at least two times.
[[nodiscard]] std::size_t interval_of(const std::vector<double>& times_s, double time_s);

}  // namespace tedavis::host_sim
