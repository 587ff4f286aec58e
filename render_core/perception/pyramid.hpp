/// Image pyramid: reduces a plane by half, and expands a level to the size of a finer one.
///
/// A pixel of a level covers 2 x 2 pixels of the finer one; weights are 1 3 3 1 horizontally and vertically, borders are
/// repeated. The filter is symmetric: a plane that is mirrored or rotated by a right angle has mirrored or rotated levels where
/// its sides are multiples of the coarsest pixel. Expansion interpolates linearly between the pixels' centres.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"

namespace tedavis::perception {

/// Elements of scratch for planes of that width.
[[nodiscard]] constexpr std::size_t reduction_scratch(int width) { return static_cast<std::size_t>(width) + 4; }
/// `coarse` has half the size of `fine`, rounded up.
void halve(const Plane& fine, const Plane& coarse, base::Span<float> scratch) noexcept;

/// Elements of scratch for planes of that width.
[[nodiscard]] constexpr std::size_t softening_scratch(int width) { return 3 * (static_cast<std::size_t>(width) + 2); }
/// Moves `share` of each pixel to each of its neighbours, horizontally, then vertically; borders are repeated. It makes block
/// means as smooth as reduced levels: use 1/16 for means of 2 x 2, 5/64 for means of 4 x 4.
void soften(const Plane& plane, float share, base::Span<float> scratch) noexcept;

/// Most levels that can be expanded at once.
inline constexpr int kMaxExpansion = 4;
/// Elements of scratch for rows of that width.
[[nodiscard]] constexpr std::size_t expansion_scratch(int width) {
    return 2 * static_cast<std::size_t>(width) + 6 * (std::size_t{1} << kMaxExpansion) + 4;
}
/// Returns row `y`, of `width` pixels, of the plane expanded by `levels`, 1..kMaxExpansion; the row lies in `scratch`.
[[nodiscard]] const float* expanded_row(const Plane& coarse, int levels, int y, int width, base::Span<float> scratch) noexcept;

}  // namespace tedavis::perception
