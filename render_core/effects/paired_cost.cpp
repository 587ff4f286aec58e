#include "render_core/effects/paired_cost.hpp"

#include <algorithm>

namespace tedavis::effects {
namespace {

double quantile(base::Span<const double> sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

double median_of(base::Span<const double> values, base::Span<double> room) {
    if (values.empty()) return 0;
    const base::Span<double> sorted = room.subspan(0, values.size());
    std::copy(values.begin(), values.end(), sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    return quantile(sorted, 0.5);
}

PairedCost paired_cost(base::Span<const double> with_ms, base::Span<const double> without_ms, base::Span<double> room) {
    const base::Span<double> differences = room.subspan(0, std::min(with_ms.size(), without_ms.size()));
    if (differences.empty()) return {};
    for (std::size_t n = 0; n < differences.size(); ++n) differences[n] = with_ms[n] - without_ms[n];
    std::sort(differences.begin(), differences.end());
    return {std::max(quantile(differences, 0.5), 0.0), (quantile(differences, 0.75) - quantile(differences, 0.25)) / 2};
}

CostSlope cost_slope(base::Span<const CostPoint> points) {
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

}  // namespace tedavis::effects
