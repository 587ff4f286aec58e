#include "platform/egl_kms/screen_mode.hpp"

#include <charconv>
#include <cstdio>

namespace tedavis::platform {
namespace {

constexpr std::uint32_t kMaxModePx = 65535, kMaxRefresh_hz = 1000, kThousandths = 1000;

/// Takes a decimal number from the front of `text`; false where there is none of 1 to `high`.
bool take_number(std::string_view& text, std::uint32_t high, std::uint32_t& value) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || value < 1 || value > high) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

/// "60" or "59.94", to its end.
bool take_refresh(std::string_view text, std::uint32_t& refresh_mhz) {
    std::uint32_t whole = 0, part = 0;
    if (!take_number(text, kMaxRefresh_hz, whole)) return false;
    refresh_mhz = whole * kThousandths;
    if (text.empty()) return true;
    if (text.front() != '.' || text.size() < 2 || text.size() > 4) return false;
    for (std::size_t n = 1; n < 4; ++n) {
        const char digit = n < text.size() ? text[n] : '0';
        if (digit < '0' || digit > '9') return false;
        part = part * 10 + static_cast<std::uint32_t>(digit - '0');
    }
    refresh_mhz += part;
    return refresh_mhz <= kMaxRefresh_hz * kThousandths;
}

}  // namespace

bool parse_screen_mode(std::string_view text, ScreenModeWish& wish) {
    if (text == "preferred") {
        wish = {};
        return true;
    }
    ScreenModeWish read;
    if (!take_number(text, kMaxModePx, read.width_px) || text.empty() || text.front() != 'x') return false;
    text.remove_prefix(1);
    if (!take_number(text, kMaxModePx, read.height_px)) return false;
    if (!text.empty() && (text.front() != '@' || !take_refresh(text.substr(1), read.refresh_mhz))) return false;
    wish = read;
    return true;
}

ModeText mode_text(std::uint32_t width_px, std::uint32_t height_px, std::uint32_t refresh_mhz) {
    char text[32];
    int size = std::snprintf(text, sizeof text, "%ux%u", width_px, height_px);
    if (refresh_mhz > 0) {
        size += std::snprintf(text + size, sizeof text - static_cast<std::size_t>(size), "@%u.%03u", refresh_mhz / kThousandths,
                              refresh_mhz % kThousandths);
        while (text[size - 1] == '0') --size;
        if (text[size - 1] == '.') --size;
    }
    return ModeText(std::string_view(text, static_cast<std::size_t>(size)));
}

}  // namespace tedavis::platform
