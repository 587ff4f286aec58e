/// A part of the screen, bounded by a line. Plain data.
#pragma once

namespace tedavis::draw {

/// The screen where x * right + y * up <= limit, x and y from -1 at the left and bottom to 1.
struct ScreenPart {
    float right = 0, up = 0, limit = 1;  ///< the whole screen
};

}  // namespace tedavis::draw
