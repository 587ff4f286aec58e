/// Fewer corners for an outline, such that the new one contains the old: what must not be entered never becomes smaller.
///
/// Two steps, the cheapest first, while all of them together add no more than is allowed: a corner that bends inwards is left
/// out, so that its notch is filled; a side between two corners that bend outwards is left out, and its neighbours go on to where
/// they meet. A step whose new sides would touch another one is not taken, so that the outline never crosses itself.
///
/// Units are the caller's. Memory  the caller's. Bounded: the square of the corners' number times kOutlineRounds. Pure; any
/// thread.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::scene {

inline constexpr std::size_t kFewestOutlineCorners = 4;
inline constexpr int kOutlineRounds = 8;  ///< each allows its steps twice as much as the one before

/// Changes the corners in place and returns how many are left. `most_growth`: of the outline's area, 0.5 for half of it more; at
/// 0 nothing is changed. An outline that crosses itself stays as it is.
[[nodiscard]] std::size_t simplify_outwards(base::Span<glm::dvec2> corners, double most_growth) noexcept;

}  // namespace tedavis::scene
