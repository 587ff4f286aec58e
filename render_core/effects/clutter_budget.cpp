#include "render_core/effects/clutter_budget.hpp"

#include <algorithm>

namespace tedavis::effects {
namespace {

/// False for what is no number.
bool exceeds(const ClutterMap& clutter, std::size_t region, double budget) {
    return budget < 1 && clutter.is_known && static_cast<double>(clutter.measure[region]) > budget;
}

double detail_left(double whole, double least, double budget) {
    const double use = whole - least;
    if (!(use >= kLeastUse)) return 1;
    return 1 - (1 - kLeastDetailLeft) * std::min((whole - budget) / use, 1.0);
}

}  // namespace

scene::DetailRegions least_detail() noexcept {
    scene::DetailRegions least;
    least.factor.fill(static_cast<float>(kLeastDetailLeft));
    return least;
}

bool is_beyond(const ClutterMap& clutter, double budget) noexcept {
    for (std::size_t n = 0; n < clutter.measure.size(); ++n)
        if (exceeds(clutter, n, budget)) return true;
    return false;
}

scene::DetailRegions tried_detail(const ClutterMeasures& clutter, double budget) noexcept {
    scene::DetailRegions regions;
    if (!clutter.least.is_known) return regions;
    for (std::size_t n = 0; n < regions.factor.size(); ++n) {
        if (!exceeds(clutter.whole, n, budget)) continue;
        const auto whole = static_cast<double>(clutter.whole.measure[n]), least = static_cast<double>(clutter.least.measure[n]);
        regions.factor[n] = static_cast<float>(detail_left(whole, least, budget));
    }
    return regions;
}

scene::DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept {
    scene::DetailRegions regions = tried_detail(clutter, budget);
    for (std::size_t n = 0; n < regions.factor.size(); ++n)
        if (regions.factor[n] < 1 && exceeds(clutter.tried, n, budget)) regions.factor[n] = static_cast<float>(kLeastDetailLeft);
    return regions;
}

}  // namespace tedavis::effects
