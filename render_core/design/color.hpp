/// Colours as design files state them.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace tedavis::design {

/// A colour with 8 bits per channel, sRGB-encoded, straight alpha. These values reach the frame unchanged.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
    friend constexpr bool operator==(Color a, Color b) {
        return a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
    }
    friend constexpr bool operator!=(Color a, Color b) { return !(a == b); }
};
static_assert(std::is_trivially_copyable_v<Color>);

struct ParsedColor {
    Color color;
    bool ok = false;
};
/// Parses "#rrggbb" or "#rrggbbaa", hexadecimal digits of either case.
[[nodiscard]] ParsedColor color_from_text(std::string_view text) noexcept;

/// Blends two colours with `share` 0..1 of the second, per channel of the encoded values, rounded to the nearest.
[[nodiscard]] Color blended(Color first, Color second, double share) noexcept;

/// Linear light 0..1 of an sRGB-encoded channel (IEC 61966-2-1), and relative luminance as WCAG defines it, for contrast
/// checks.
[[nodiscard]] double linear_light(std::uint8_t channel) noexcept;
[[nodiscard]] double relative_luminance(Color color) noexcept;

}  // namespace tedavis::design
