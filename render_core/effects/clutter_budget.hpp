/// Holds a budget of clutter region by region: where a picture with all its detail is beyond it, data there keep so much less
/// that the picture is within it, as far as their giving way helps at all.
///
/// How much it helps is known from a second measure, of the same picture with the least detail left. In between density is first
/// taken to change in proportion; a third measure, of the picture that this leaves, tells where that was not enough. A function
/// of pictures that nobody has lowered before: it cannot swing.
///
/// The measures are an input, of whoever looks at the pictures; pure. Any thread.
#pragma once

#include "render_core/scene/detail_regions.hpp"

namespace tedavis::effects {

/// Of the regions of the screen, as in scene::DetailRegions; 0 calm, 1 as cluttered as the measure knows.
struct ClutterMap {
    bool is_known = false;
    std::array<float, scene::DetailRegions::kAcross * scene::DetailRegions::kDown> measure{};
};

struct ClutterMeasures {
    ClutterMap whole;  ///< with all detail
    ClutterMap least;  ///< with kLeastDetailLeft of what gives way, everywhere; of no use where the other is within the budget
    ClutterMap tried;  ///< with tried_detail() left
};

inline constexpr double kLeastDetailLeft = 0.25;
inline constexpr double kLeastUse = 0.002;  ///< of giving way, in the measure: for less than this nothing is taken away

/// Everywhere.
[[nodiscard]] scene::DetailRegions least_detail() noexcept;
/// Whether some region is beyond the budget, 0..1; 1 is none. What is not a number, or not known, is not.
[[nodiscard]] bool is_beyond(const ClutterMap& clutter, double budget) noexcept;

/// In proportion, from the first two measures. Where it is not known what giving way would help, or it helps nothing, nothing is
/// taken away.
[[nodiscard]] scene::DetailRegions tried_detail(const ClutterMeasures& clutter, double budget) noexcept;
/// What keeps the budget: that, and the least where it was tried and was not enough.
[[nodiscard]] scene::DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept;

}  // namespace tedavis::effects
