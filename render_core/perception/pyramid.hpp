/// Smaller versions of a plane, each half as large as the one before, and how they look at a finer one's size.
///
/// A pixel of a level lies over two by two of the finer one; weights are 1 3 3 1 across and down, borders repeated. As no pixel
/// is preferred, a plane that is mirrored or turned by a right angle has the mirrored or turned levels where its sides are
/// multiples of the coarsest pixel. What is seen at a finer size is interpolated between the pixels' middles.
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
/// Gives `share` of each pixel to each of its neighbours across, then down; borders repeated. Makes means of blocks as wide as
/// reduced levels are: a mean of 2 x 2 with 1/16, of 4 x 4 with 5/64.
void soften(const Plane& plane, float share, base::Span<float> scratch) noexcept;

/// Levels that can be bridged at once.
inline constexpr int kMaxExpansion = 4;
/// Elements of scratch for rows of that width.
[[nodiscard]] constexpr std::size_t expansion_scratch(int width) {
    return 2 * static_cast<std::size_t>(width) + 6 * (std::size_t{1} << kMaxExpansion) + 4;
}
/// Row `y` of `width` pixels of a plane that is `levels` finer, 1..kMaxExpansion; lies in `scratch`.
[[nodiscard]] const float* expanded_row(const Plane& coarse, int levels, int y, int width, base::Span<float> scratch) noexcept;

}  // namespace tedavis::perception
