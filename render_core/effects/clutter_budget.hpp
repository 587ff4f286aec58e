/// Holds a budget of clutter region by region: where a picture with all its detail is beyond it, data there keep so much less
/// that the picture is within it, as far as their giving way helps at all.
///
/// How much it helps is known from a second measure, of the same picture with the least detail left. In between density is taken
/// to change in proportion; the picture that this leaves is measured, and what is not enough gives way further, for regions are
/// not independent: things reach over their borders, and fewer of them stand elsewhere. Of the pictures that were measured the
/// one with the least excess is chosen, or the one with the least detail where all have too much. A function of pictures that
/// nobody has lowered before: it cannot swing.
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
    ClutterMap least;  ///< with least_detail(); of no use where the other is within the budget
};

inline constexpr double kMinDetailLeft = 0.25;
inline constexpr double kMinUse = 0.01;  ///< of giving way, in the measure: for less than this nothing is taken away

/// Everywhere.
[[nodiscard]] scene::DetailRegions least_detail() noexcept;
/// Whether some region is beyond the budget, 0..1; 1 is none. What is not a number, or not known, is not.
[[nodiscard]] bool is_beyond(const ClutterMap& clutter, double budget) noexcept;

/// What would suffice in proportion. Where it is not known what giving way would help, or it helps nothing, nothing is taken
/// away.
[[nodiscard]] scene::DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept;
/// What would, after a picture with `left` had `reached`: less where that is beyond what can be. `haste` times as much is taken
/// away as would do in proportion, 1 or more.
[[nodiscard]] scene::DetailRegions less_detail(const scene::DetailRegions& left, const ClutterMap& reached,
                                               const ClutterMeasures& clutter, double budget, double haste) noexcept;
/// The last resort: the least where that is beyond what can be, and in the regions round it, since things reach over borders.
[[nodiscard]] scene::DetailRegions least_round(const scene::DetailRegions& left, const ClutterMap& reached,
                                               const ClutterMeasures& clutter, double budget) noexcept;
/// By how much a picture is beyond the budget where it could be within it, or nearer: all regions together.
[[nodiscard]] double excess(const ClutterMap& reached, const ClutterMeasures& clutter, double budget) noexcept;

}  // namespace tedavis::effects
