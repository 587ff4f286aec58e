/// Holds a budget of clutter for each region of the picture: where the picture with full detail exceeds it, the detail of data
/// there is reduced until the picture is within the budget, as far as reduction helps.
///
/// The effect of reduction is known from a second measurement, of the same picture with the least detail. Clutter is assumed to
/// change linearly between the two. The resulting picture is measured, and detail is reduced further where that does not
/// suffice, because regions are not independent: objects extend over their borders, and fewer objects may be placed elsewhere.
/// Of the measured pictures the one with the least excess is chosen, or the one with the least detail where all exceed the
/// budget by much. The inputs are pictures that no earlier result has reduced, so the result cannot oscillate.
///
/// Measurements are inputs. Pure; any thread.
#pragma once

#include "render_core/scene/detail_regions.hpp"

namespace tedavis::effects {

/// Clutter of the regions of the screen, laid out as in scene::DetailRegions; 0 is none, 1 the measure's maximum.
struct ClutterMap {
    bool is_known = false;
    std::array<float, scene::DetailRegions::kAcross * scene::DetailRegions::kDown> measure{};
};

struct ClutterMeasures {
    ClutterMap whole;  ///< with full detail
    ClutterMap least;  ///< with least_detail(); not needed where `whole` is within the budget
};

inline constexpr double kMinDetailLeft = 0.25;
inline constexpr double kMinUse = 0.01;  ///< least reduction of clutter for which detail is reduced

/// Returns the least detail in all regions.
[[nodiscard]] scene::DetailRegions least_detail() noexcept;
/// True where a region exceeds the budget 0..1; 1 means no budget. Unknown values and NaN do not exceed it.
[[nodiscard]] bool is_beyond(const ClutterMap& clutter, double budget) noexcept;

/// Returns the detail that suffices by linear interpolation. Where the effect of reduction is unknown or too small, detail is
/// not reduced.
[[nodiscard]] scene::DetailRegions detail_within(const ClutterMeasures& clutter, double budget) noexcept;
/// Returns the detail after a picture with the detail `left` had the clutter `reached`: less where that exceeds what is
/// possible. The linear reduction is multiplied by `haste`, 1 or more.
[[nodiscard]] scene::DetailRegions less_detail(const scene::DetailRegions& left, const ClutterMap& reached,
                                               const ClutterMeasures& clutter, double budget, double haste) noexcept;
/// The last step: returns the least detail where the clutter exceeds what is possible, and in the neighbouring regions, since
/// objects extend over borders.
[[nodiscard]] scene::DetailRegions least_round(const scene::DetailRegions& left, const ClutterMap& reached,
                                               const ClutterMeasures& clutter, double budget) noexcept;
/// Returns the sum over regions of the clutter beyond the budget, as far as it could be avoided.
[[nodiscard]] double excess(const ClutterMap& reached, const ClutterMeasures& clutter, double budget) noexcept;

}  // namespace tedavis::effects
