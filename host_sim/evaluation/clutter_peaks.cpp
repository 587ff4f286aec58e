#include "host_sim/evaluation/clutter_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

/// The lowest value on the way from `index` in steps of `step` to what is higher, or to the end.
double valley(const std::vector<double>& values, std::size_t index, int step) {
    double lowest = values[index];
    const auto count = static_cast<std::ptrdiff_t>(values.size());
    for (auto at = static_cast<std::ptrdiff_t>(index); at >= 0 && at < count; at += step) {
        const double value = values[static_cast<std::size_t>(at)];
        if (value > values[index]) break;
        lowest = std::min(lowest, value);
    }
    return lowest;
}

/// At an end of the curve only the side that there is counts.
double prominence_of(const std::vector<double>& values, std::size_t first, std::size_t last) {
    const double height = values[first];
    if (first == 0) return height - valley(values, last, 1);
    if (last + 1 == values.size()) return height - valley(values, first, -1);
    return height - std::max(valley(values, first, -1), valley(values, last, 1));
}

std::vector<Peak> all_peaks(const std::vector<double>& values) {
    std::vector<Peak> peaks;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t last = first;
        while (last + 1 < values.size() && values[last + 1] == values[first]) ++last;
        const bool rises = first == 0 || values[first - 1] < values[first];
        const bool falls = last + 1 == values.size() || values[last + 1] < values[first];
        if (rises && falls && last - first + 1 < values.size())
            peaks.push_back({(first + last) / 2, prominence_of(values, first, last)});
        first = last + 1;
    }
    return peaks;
}

/// Order of importance, then of time.
template <class Rank>
void sort_down(std::vector<Peak>& peaks, Rank rank) {
    std::stable_sort(peaks.begin(), peaks.end(), [&](const Peak& a, const Peak& b) { return rank(a) > rank(b); });
}

}  // namespace

PeakRule peak_rule_for(const std::vector<double>& times_s, const std::vector<double>& values) {
    constexpr double kShareOfRange = 1.0 / 7, kMin = 0.005, kShareOfFlight = 1.0 / 30, kMin_s = 3;
    PeakRule rule{kMin, kMin_s, 6};
    if (values.empty()) return rule;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    rule.least_prominence = std::max(kMin, kShareOfRange * (*high - *low));
    rule.least_distance_s = std::max(kMin_s, kShareOfFlight * std::abs(times_s.back() - times_s.front()));
    return rule;
}

std::vector<Peak> find_peaks(const std::vector<double>& times_s, const std::vector<double>& values, const PeakRule& rule) {
    std::vector<Peak> candidates = all_peaks(values), kept;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const Peak& peak) { return peak.prominence < rule.least_prominence; }),
                     candidates.end());
    sort_down(candidates, [&](const Peak& peak) { return values[peak.index]; });
    for (const Peak& peak : candidates) {
        const bool is_apart = std::all_of(kept.begin(), kept.end(), [&](const Peak& higher) {
            return std::abs(times_s[peak.index] - times_s[higher.index]) >= rule.least_distance_s;
        });
        if (is_apart) kept.push_back(peak);
    }
    sort_down(kept, [](const Peak& peak) { return peak.prominence; });
    if (kept.size() > rule.most) kept.resize(rule.most);
    std::sort(kept.begin(), kept.end(), [](const Peak& a, const Peak& b) { return a.index < b.index; });
    return kept;
}

}  // namespace tedavis::host_sim
