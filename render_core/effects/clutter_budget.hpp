/// Holds a budget of clutter region by region: where a measure of the picture says more than the budget, data there keep so much
/// less of their detail.
///
/// The measure is an input, of whoever looks at the picture; this is a pure function of it. Any thread.
#pragma once

#include "render_core/scene/detail_regions.hpp"

namespace tedavis::effects {

/// Of the regions of the screen, as in scene::DetailRegions; 0 calm, 1 as cluttered as the measure knows.
struct ClutterMap {
    bool is_known = false;
    std::array<float, scene::DetailRegions::kAcross * scene::DetailRegions::kDown> measure{};
};

inline constexpr double kLeastDetailLeft = 0.25;

/// `budget` 0..1; 1 is none. What is not a number, or not known, takes nothing away.
[[nodiscard]] scene::DetailRegions detail_within(const ClutterMap& clutter, double budget) noexcept;

}  // namespace tedavis::effects
