/// The smallest text of the display, and the lowest row for it.
#pragma once

#include <algorithm>

namespace tedavis::draw {

/// Size of the smallest text, pixels per em, on screens of any size.
inline constexpr float kMinText_px = 11;
/// Height of the lowest row, in ems of the smallest text: capitals and descenders.
inline constexpr float kMinRowEms = 1.1f;

/// Returns `size`, a multiple of a text of `text_px` pixels, raised where necessary to the size of the smallest text.
[[nodiscard]] constexpr float legible_size(float size, float text_px) { return std::max(size, kMinText_px / text_px); }

/// Returns the height in pixels of a row of `texts` texts, but at least that of the lowest row.
[[nodiscard]] constexpr float legible_row_px(float texts, float text_px) {
    return std::max(texts * text_px, kMinRowEms * kMinText_px);
}

}  // namespace tedavis::draw
