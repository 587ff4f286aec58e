/// Simplifies an outline so that the new one contains the old one: an area that must not be entered never becomes smaller.
///
/// Two kinds of steps are taken, those that add the least area first, while the added area is within the limit: a concave
/// corner is removed, which fills its notch; or a side between two convex corners is removed, and its neighbours are extended
/// to their intersection. A step whose new sides would touch another side is not taken, so the outline never crosses itself.
///
/// Units are the caller's. Memory  the caller's. Bounded: the square of the corners' number times kOutlineRounds. Pure; any
/// thread.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::scene {

inline constexpr std::size_t kFewestOutlineCorners = 4;
inline constexpr int kOutlineRounds = 8;  ///< each round allows steps twice as large as the one before

/// Changes the corners in place and returns how many are left. `most_growth` is the largest growth as a share of the outline's
/// area; 0 changes nothing. An outline that crosses itself is left unchanged.
[[nodiscard]] std::size_t simplify_outwards(base::Span<glm::dvec2> corners, double most_growth) noexcept;

}  // namespace tedavis::scene
