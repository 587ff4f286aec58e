/// The smallest text of the display, and the lowest row that it stands in.
#pragma once

#include <algorithm>

namespace tedavis::draw {

/// Pixels an em below which no text is drawn, whatever the size of the screen.
inline constexpr float kMinText_px = 11;
/// Ems of the smallest text below which no row of text is: capitals, and what letters reach below the line.
inline constexpr float kMinRowEms = 1.1f;

/// `size` in texts of `text_px` pixels, or what makes the smallest text where that is more.
[[nodiscard]] constexpr float legible_size(float size, float text_px) { return std::max(size, kMinText_px / text_px); }

/// Pixels of a row of `texts` texts, or of the smallest text where that is more.
[[nodiscard]] constexpr float legible_row_px(float texts, float text_px) {
    return std::max(texts * text_px, kMinRowEms * kMinText_px);
}

}  // namespace tedavis::draw
