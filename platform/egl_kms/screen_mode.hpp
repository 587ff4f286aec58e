/// A mode of a screen, in words: "1024x768@60", "1024x768" or "preferred".
///
/// Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

/// The mode that a board asks for. Without a size it is the one that the screen itself prefers (EDID).
struct ScreenModeWish {
    std::uint32_t width_px = 0, height_px = 0;
    std::uint32_t refresh_mhz = 0;  ///< thousandths of a hertz; 0: any

    [[nodiscard]] bool is_preferred() const { return width_px == 0; }
};

/// A refresh rate is met within half a hertz: "@60" also means 59.94.
inline constexpr std::uint32_t kRefreshTolerance_mhz = 500;

/// Reads "preferred", "WxH" or "WxH@Hz", with at most three decimals of the rate. False where the text is none of these, a
/// side is not 1 to 65535 pixels or the rate is not 1 to 1000 Hz; `wish` is unchanged then.
[[nodiscard]] bool parse_screen_mode(std::string_view text, ScreenModeWish& wish);

using ModeText = base::FixedString<31>;

/// Returns "1024x768@60" or "1920x1080@59.94"; without a rate "1024x768".
[[nodiscard]] ModeText mode_text(std::uint32_t width_px, std::uint32_t height_px, std::uint32_t refresh_mhz);

}  // namespace tedavis::platform
