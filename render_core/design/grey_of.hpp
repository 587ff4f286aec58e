/// Converts a colour to grey. Pure function; any thread.
#pragma once

#include <cmath>

#include "render_core/design/color.hpp"

namespace tedavis::design {

/// Returns the grey of the same luma (Rec. 709, of the encoded values, as in the shaders) and opacity.
[[nodiscard]] inline Color grey_of(Color color) noexcept {
    const auto level = static_cast<std::uint8_t>(std::lround(0.2126 * color.red + 0.7152 * color.green + 0.0722 * color.blue));
    return {level, level, level, color.alpha};
}

}  // namespace tedavis::design
