/// How different two pictures look: one number, by CIEDE2000.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"

namespace tedavis::design {

/// Returns the mean CIEDE2000 difference of the pixels of two pictures of one size: RGBA8 in the same order of rows, of which the
/// alpha is not looked at. 0 for pictures without pixels; what one of the two has more is left out.
[[nodiscard]] double mean_color_difference(base::Span<const std::uint8_t> first, base::Span<const std::uint8_t> second) noexcept;

}  // namespace tedavis::design
