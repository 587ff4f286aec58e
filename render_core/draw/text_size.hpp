/// The smallest text of the display.
#pragma once

namespace tedavis::draw {

/// Pixels an em below which no text is drawn, whatever the size of the screen.
inline constexpr float kMinText_px = 11;

}  // namespace tedavis::draw
