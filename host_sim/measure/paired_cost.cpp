#include "host_sim/measure/paired_cost.hpp"

#include <algorithm>
#include <cstddef>

namespace tedavis::host_sim {
namespace {

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return quantile(values, 0.5);
}

PairedCost paired_cost(const std::vector<double>& with_ms, const std::vector<double>& without_ms) {
    std::vector<double> differences;
    for (std::size_t n = 0; n < std::min(with_ms.size(), without_ms.size()); ++n)
        differences.push_back(with_ms[n] - without_ms[n]);
    if (differences.empty()) return {};
    std::sort(differences.begin(), differences.end());
    return {std::max(quantile(differences, 0.5), 0.0), (quantile(differences, 0.75) - quantile(differences, 0.25)) / 2};
}

CostSlope cost_slope(const std::vector<CostPoint>& points) {
    if (points.empty()) return {};
    CostPoint mean;
    for (const CostPoint& point : points) {
        mean.things += point.things / static_cast<double>(points.size());
        mean.ms += point.ms / static_cast<double>(points.size());
    }
    double across = 0, along = 0;
    for (const CostPoint& point : points) {
        across += (point.things - mean.things) * (point.ms - mean.ms);
        along += (point.things - mean.things) * (point.things - mean.things);
    }
    const double slope = along > 0 ? std::max(across / along, 0.0) : 0;
    return {mean.ms - slope * mean.things, slope};
}

}  // namespace tedavis::host_sim
