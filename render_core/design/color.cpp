#include "render_core/design/color.hpp"

#include <cmath>
#include <cstddef>

namespace tedavis::design {
namespace {

/// 16 for what is no hexadecimal digit.
unsigned digit_value(char digit) noexcept {
    if (digit >= '0' && digit <= '9') return static_cast<unsigned>(digit - '0');
    if (digit >= 'a' && digit <= 'f') return static_cast<unsigned>(digit - 'a' + 10);
    return digit >= 'A' && digit <= 'F' ? static_cast<unsigned>(digit - 'A' + 10) : 16u;
}

std::uint8_t blended_channel(std::uint8_t first, std::uint8_t second, double share) noexcept {
    return static_cast<std::uint8_t>(std::lround(first + (static_cast<double>(second) - first) * share));
}

}  // namespace

ParsedColor color_from_text(std::string_view text) noexcept {
    if ((text.size() != 7 && text.size() != 9) || text.front() != '#') return {};
    std::uint8_t channels[4] = {0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
        const unsigned high = digit_value(text[2 * i + 1]), low = digit_value(text[2 * i + 2]);
        if (high > 15 || low > 15) return {};
        channels[i] = static_cast<std::uint8_t>(high * 16 + low);
    }
    return {{channels[0], channels[1], channels[2], channels[3]}, true};
}

Color blended(Color first, Color second, double share) noexcept {
    const double inside = share > 0 ? (share < 1 ? share : 1.0) : 0.0;
    return {blended_channel(first.red, second.red, inside), blended_channel(first.green, second.green, inside),
            blended_channel(first.blue, second.blue, inside), blended_channel(first.alpha, second.alpha, inside)};
}

double linear_light(std::uint8_t channel) noexcept {
    const double encoded = channel / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double relative_luminance(Color color) noexcept {
    return 0.2126 * linear_light(color.red) + 0.7152 * linear_light(color.green) + 0.0722 * linear_light(color.blue);
}

}  // namespace tedavis::design
