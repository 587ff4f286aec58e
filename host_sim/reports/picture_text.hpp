/// Text in pictures of reports, such as labels, in the display's typeface (render_core/draw/font_atlas.hpp).
#pragma once

#include <array>
#include <string_view>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct PictureTextStyle {
    float size_px = 16;  ///< an em
    std::array<std::uint8_t, 3> color{};
};

/// Returns the style, with a smaller size if `text` would be wider than `room_px`.
[[nodiscard]] PictureTextStyle fitted(std::string_view text, PictureTextStyle style, float room_px);

/// Draws UTF-8 text from the pen at x on the baseline y, pixels from the top left corner; what lies outside is cut off. The text
/// is blended over the picture by its coverage; drawn pixels become opaque.
void draw_text(RgbaPicture& picture, std::string_view text, float x, float baseline_y, const PictureTextStyle& style);

}  // namespace tedavis::host_sim
