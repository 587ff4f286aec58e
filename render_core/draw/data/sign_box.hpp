/// The room of a sign in the picture: its icon above its position, with its name on one side. Plain data, in pixels.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

/// Side of a name beside its icon, the preferred one first.
enum class SignSide : std::uint8_t { right, left, above, none };
inline constexpr SignSide kNameSides[] = {SignSide::right, SignSide::left, SignSide::above};
/// Stem lengths: the short one, and longer ones in steps of the text size, for signs that find no room on it.
inline constexpr std::uint8_t kSignStems = 7;
inline constexpr float kStemStep = 1.25f;

struct SignBox {
    Point middle;                                 ///< of the icon
    float half_px = 0;                            ///< from the middle to its edge
    float gap_px = 0;                             ///< gap kept free round it
    float foot_px = 0;                            ///< from the middle down to its position; 0: no stem that takes room
    float name_width_px = 0, name_height_px = 0;  ///< of all lines

    /// Returns the box on a longer stem, which itself takes no room; 0: unchanged.
    [[nodiscard]] SignBox raised(std::uint8_t stem, float text_px) const {
        SignBox box = *this;
        if (stem == 0) return box;
        box.middle.y -= kStemStep * static_cast<float>(stem) * text_px;
        box.foot_px = 0;
        return box;
    }

    [[nodiscard]] Rect with(SignSide side) const {
        const float half = half_px + gap_px;
        Rect box{middle.x - half, middle.y - half, 2 * half, std::max(foot_px, half) + half};
        if (side == SignSide::none) return box;
        const float width = name_width_px + gap_px, height = name_height_px;
        if (side == SignSide::above) {
            box.y -= height;
            box.height += height;
            box.x = std::min(box.x, middle.x - 0.5f * (width + gap_px));
            box.width = std::max(box.width, width + gap_px);
            return box;
        }
        const float more = std::max(0.5f * height - half, 0.0f);
        box.y -= more;
        box.height = std::max(box.height + more, height);
        box.width += width;
        if (side == SignSide::left) box.x -= width;
        return box;
    }
};

}  // namespace tedavis::draw
