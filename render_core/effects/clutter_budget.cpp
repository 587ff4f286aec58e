#include "render_core/effects/clutter_budget.hpp"

#include <algorithm>

namespace tedavis::effects {
namespace {

/// False for what is no number.
bool exceeds(const ClutterMap& clutter, std::size_t region, double limit) {
    return clutter.is_known && static_cast<double>(clutter.measure[region]) > limit;
}

/// As calm as a region can be, or as it must be.
double limit_of(const ClutterMeasures& clutter, std::size_t region, double budget) {
    return std::max(budget, static_cast<double>(clutter.least.measure[region]) + kLeastUse);
}

/// Of what is kept when a density falls from `from` to the budget, with all that can give way to `least`.
double kept(double from, double least, double budget, double detail) {
    const double use = from - least;
    if (!(use >= kLeastUse)) return detail;
    return detail - (detail - kLeastDetailLeft) * std::clamp((from - budget) / use, 0.0, 1.0);
}

}  // namespace

scene::DetailRegions least_detail() noexcept {
    scene::DetailRegions least;
    least.factor.fill(static_cast<float>(kLeastDetailLeft));
    return least;
}

bool is_beyond(const ClutterMap& clutter, double budget) noexcept {
    for (std::size_t n = 0; n < clutter.measure.size(); ++n)
        if (budget < 1 && exceeds(clutter, n, budget)) return true;
    return false;
}

scene::DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept {
    return budget < 1 ? less_detail(scene::DetailRegions(), clutter.whole, clutter, budget) : scene::DetailRegions();
}

scene::DetailRegions less_detail(const scene::DetailRegions& left, const ClutterMap& reached, const ClutterMeasures& clutter,
                                 double budget) noexcept {
    scene::DetailRegions less = left;
    if (!clutter.least.is_known) return less;
    for (std::size_t n = 0; n < less.factor.size(); ++n) {
        if (!exceeds(reached, n, limit_of(clutter, n, budget))) continue;
        const auto from = static_cast<double>(reached.measure[n]), least = static_cast<double>(clutter.least.measure[n]);
        less.factor[n] = static_cast<float>(kept(from, least, budget, static_cast<double>(left.factor[n])));
    }
    return less;
}

double excess(const ClutterMap& reached, const ClutterMeasures& clutter, double budget) noexcept {
    double sum = 0;
    for (std::size_t n = 0; n < reached.measure.size(); ++n)
        if (const double limit = limit_of(clutter, n, budget); exceeds(reached, n, limit))
            sum += static_cast<double>(reached.measure[n]) - limit;
    return sum;
}

}  // namespace tedavis::effects
