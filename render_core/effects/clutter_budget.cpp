#include "render_core/effects/clutter_budget.hpp"

#include <cmath>

namespace tedavis::effects {

scene::DetailRegions detail_within(const ClutterMap& clutter, double budget) noexcept {
    scene::DetailRegions regions;
    if (!clutter.is_known || budget >= 1) return regions;
    for (std::size_t n = 0; n < clutter.measure.size(); ++n) {
        const auto measure = static_cast<double>(clutter.measure[n]);
        if (measure > budget) regions.factor[n] = static_cast<float>(std::fmax(budget / measure, kLeastDetailLeft));
    }
    return regions;
}

}  // namespace tedavis::effects
