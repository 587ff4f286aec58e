#include "host_sim/importers/monotone_curve.hpp"

#include <algorithm>
#include <utility>

namespace tedavis::host_sim {

std::size_t interval_of(const std::vector<double>& times_s, double time_s) {
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
    const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - times_s.begin() - 1));
    return std::min(index, times_s.size() - 2);
}

MonotoneCurve::MonotoneCurve(std::vector<double> times_s, std::vector<double> values)
    : times_(std::move(times_s)), values_(std::move(values)) {
    const std::size_t count = times_.size();
    slopes_.assign(count, 0.0);
    const auto chord = [&](std::size_t i) { return (values_[i + 1] - values_[i]) / (times_[i + 1] - times_[i]); };
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double before = chord(i - 1), after = chord(i);
        if (before * after <= 0) continue;  // an extremum of the samples is one of the curve
        const double h0 = times_[i] - times_[i - 1], h1 = times_[i + 1] - times_[i];
        const double alpha = (h0 + 2 * h1) / (3 * (h0 + h1));
        slopes_[i] = before * after / (alpha * after + (1 - alpha) * before);
    }
    if (count >= 2) {
        slopes_[0] = chord(0);
        slopes_[count - 1] = chord(count - 2);
    }
}

bool MonotoneCurve::covers(double time_s, double longest_gap_s) const {
    if (times_.empty() || time_s < times_.front() || time_s > times_.back()) return false;
    if (times_.size() == 1) return true;
    const std::size_t i = interval_of(times_, time_s);
    return times_[i + 1] - times_[i] <= longest_gap_s;
}

double MonotoneCurve::at(double time_s) const {
    if (times_.size() == 1 || time_s <= times_.front()) return values_.front();
    if (time_s >= times_.back()) return values_.back();
    const std::size_t i = interval_of(times_, time_s);
    const double h = times_[i + 1] - times_[i], t = (time_s - times_[i]) / h, s = 1 - t;
    const double value = values_[i] * s * s * (1 + 2 * t) + values_[i + 1] * t * t * (3 - 2 * t) +
                         h * t * s * (slopes_[i] * s - slopes_[i + 1] * t);
    return std::clamp(value, std::min(values_[i], values_[i + 1]), std::max(values_[i], values_[i + 1]));  // rounding only
}

}  // namespace tedavis::host_sim
