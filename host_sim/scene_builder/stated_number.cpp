#include "host_sim/scene_builder/stated_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "host_sim/calendar_time.hpp"

namespace tedavis::host_sim {
namespace {

std::string_view stripped(std::string_view text) {
    constexpr std::string_view kSpaces = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    text.remove_suffix(text.size() - std::min(text.find_last_not_of(kSpaces) + 1, text.size()));
    return text;
}

/// GDAL writes dates with slashes, and zones as hours alone.
std::string as_iso8601(std::string_view text) {
    std::string iso(text);
    std::replace(iso.begin(), iso.end(), '/', '-');
    constexpr std::size_t kBeforeZone = 19;
    const std::size_t sign = iso.find_first_of("+-", std::min(kBeforeZone, iso.size()));
    if (sign != std::string::npos && iso.size() == sign + 3) iso += "00";
    return iso;
}

}  // namespace

std::optional<double> stated_number(std::string_view text) {
    text = stripped(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return is_whole ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> stated_instant_ns(std::string_view text) {
    text = stripped(text);
    if (const auto date = parse_iso8601(as_iso8601(text))) return date->ns;
    const auto seconds = parse_unix_seconds(text);
    return seconds ? std::optional(seconds->ns) : std::nullopt;
}

}  // namespace tedavis::host_sim
