#include "render_core/effects/clutter_budget.hpp"

#include <algorithm>

namespace tedavis::effects {
namespace {

using scene::DetailRegions;

/// False for what is no number.
bool exceeds(const ClutterMap& clutter, std::size_t region, double limit) {
    return clutter.is_known && static_cast<double>(clutter.measure[region]) > limit;
}

/// As calm as a region can be, or as it must be.
double limit_of(const ClutterMeasures& clutter, std::size_t region, double budget) {
    return std::max(budget, static_cast<double>(clutter.least.measure[region]) + kMinUse);
}

/// Of the way to the least detail, what brings a density from `from` to the budget where all of the way leads to `least`.
double share_of_way(double from, double least, double budget) {
    const double use = from - least;
    return use >= kMinUse ? std::max(from - budget, 0.0) / use : 0;
}

void take_round(DetailRegions& regions, std::size_t column, std::size_t row) {
    const std::size_t first = column > 0 ? column - 1 : 0, last = std::min(column + 1, DetailRegions::kAcross - 1);
    for (std::size_t y = row > 0 ? row - 1 : 0; y <= std::min(row + 1, DetailRegions::kDown - 1); ++y)
        for (std::size_t x = first; x <= last; ++x)
            regions.factor[y * DetailRegions::kAcross + x] = static_cast<float>(kMinDetailLeft);
}

}  // namespace

DetailRegions least_detail() noexcept {
    DetailRegions least;
    least.factor.fill(static_cast<float>(kMinDetailLeft));
    return least;
}

bool is_beyond(const ClutterMap& clutter, double budget) noexcept {
    for (std::size_t n = 0; n < clutter.measure.size(); ++n)
        if (budget < 1 && exceeds(clutter, n, budget)) return true;
    return false;
}

DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept {
    return budget < 1 ? less_detail(DetailRegions(), clutter.whole, clutter, budget, 1) : DetailRegions();
}

DetailRegions less_detail(const DetailRegions& left, const ClutterMap& reached, const ClutterMeasures& clutter, double budget,
                          double haste) noexcept {
    DetailRegions less = left;
    if (!clutter.least.is_known) return less;
    for (std::size_t n = 0; n < less.factor.size(); ++n) {
        if (!exceeds(reached, n, limit_of(clutter, n, budget))) continue;
        const auto from = static_cast<double>(reached.measure[n]), least = static_cast<double>(clutter.least.measure[n]);
        const double detail = static_cast<double>(left.factor[n]), share = haste * share_of_way(from, least, budget);
        less.factor[n] = static_cast<float>(detail - (detail - kMinDetailLeft) * std::min(share, 1.0));
    }
    return less;
}

DetailRegions least_round(const DetailRegions& left, const ClutterMap& reached, const ClutterMeasures& clutter,
                          double budget) noexcept {
    DetailRegions less = left;
    for (std::size_t n = 0; n < less.factor.size(); ++n)
        if (exceeds(reached, n, limit_of(clutter, n, budget)))
            take_round(less, n % DetailRegions::kAcross, n / DetailRegions::kAcross);
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
