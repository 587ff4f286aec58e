/// The smallest text of the display.
#pragma once

#include <algorithm>

namespace tedavis::draw {

/// Pixels an em below which no text is drawn, whatever the size of the screen.
inline constexpr float kMinText_px = 11;

/// `size` in texts of `text_px` pixels, or what makes the smallest text where that is more.
[[nodiscard]] constexpr float legible_size(float size, float text_px) { return std::max(size, kMinText_px / text_px); }

}  // namespace tedavis::draw
