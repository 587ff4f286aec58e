#include "bus/switches/switch_log.hpp"

#include <cstdio>

namespace tedavis::bus {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::size_t kMaxSecondDigits = 10;
constexpr std::int64_t kMaxSeconds = 9'000'000'000;  // int64 nanoseconds hold 9.22e9

std::string_view without_trailing_blanks(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r");
    return last == std::string_view::npos ? std::string_view() : text.substr(0, last + 1);
}

/// Takes the leading blank-separated word off `text`.
std::string_view take_word(std::string_view& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) {
        text = {};
        return {};
    }
    const std::size_t end = text.find_first_of(" \t", begin);
    const std::string_view word = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end);
    return word;
}

/// All of `digits` as a number; false when one of them is no digit.
bool read_digits(std::string_view digits, std::int64_t& value) {
    value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return false;
        value = value * 10 + (c - '0');
    }
    return true;
}

/// "(seconds.fraction)".
bool read_stamp(std::string_view word, base::Time& time) {
    if (word.size() < 3 || word.front() != '(' || word.back() != ')') return false;
    const std::string_view inside = word.substr(1, word.size() - 2);
    const std::size_t point = inside.find('.');
    if (point == std::string_view::npos || point == 0 || point > kMaxSecondDigits) return false;
    const std::string_view fraction = inside.substr(point + 1);
    if (fraction.size() != 6 && fraction.size() != 9) return false;
    std::int64_t seconds = 0, part = 0;
    if (!read_digits(inside.substr(0, point), seconds) || !read_digits(fraction, part) || seconds > kMaxSeconds) return false;
    time.ns = seconds * kNanosecondsPerSecond + (fraction.size() == 6 ? part * 1000 : part);
    return true;
}

SwitchLogLine malformed(SwitchLineFault fault) { return {SwitchLineKind::malformed, fault, {}}; }

}  // namespace

bool has_switch_log_header(std::string_view text) noexcept {
    const std::string_view expected = kSwitchLogHeader.substr(0, kSwitchLogHeader.size() - 1);
    const std::size_t end = text.find('\n');
    return without_trailing_blanks(text.substr(0, end)) == expected;
}

const char* describe(SwitchLineFault fault) noexcept {
    switch (fault) {
        case SwitchLineFault::none: return "nothing is wrong";
        case SwitchLineFault::time_stamp: return "the time stamp is not (seconds.fraction) with 6 or 9 digits";
        case SwitchLineFault::line_name: return "the switch config has no such chip and line";
        case SwitchLineFault::level: return "the level is not a single 0 or 1";
        case SwitchLineFault::time_runs_back: return "the time is before that of an earlier line";
    }
    return "nothing is wrong";
}

SwitchLogLine parse_switch_log_line(std::string_view line, const SwitchConfig& config) noexcept {
    std::string_view rest = without_trailing_blanks(line);
    const std::string_view stamp = take_word(rest);
    if (stamp.empty() || stamp.front() == '#') return {SwitchLineKind::comment, SwitchLineFault::none, {}};
    SwitchLogLine result;
    if (!read_stamp(stamp, result.edge.time)) return malformed(SwitchLineFault::time_stamp);
    const std::string_view name = take_word(rest);
    const std::string_view level = take_word(rest);
    if ((level != "0" && level != "1") || !take_word(rest).empty()) return malformed(SwitchLineFault::level);
    const std::size_t index = config.find_line(name);
    if (index == config.lines.size()) return {SwitchLineKind::unknown_line, SwitchLineFault::line_name, {}};
    result.kind = SwitchLineKind::edge;
    result.edge.line = static_cast<std::uint8_t>(index);
    result.edge.level = level == "1";
    return result;
}

std::size_t format_switch_log_line(const SwitchEdge& edge, const SwitchConfig& config, base::Span<char> out) noexcept {
    if (out.size() < kMaxSwitchLogLine || edge.time.ns < 0 || edge.line >= config.lines.size()) return 0;
    const SwitchLine& line = config.lines[edge.line];
    const auto seconds = static_cast<long long>(edge.time.ns / kNanosecondsPerSecond);
    const auto fraction = static_cast<long long>(edge.time.ns % kNanosecondsPerSecond);
    const bool micro = fraction % 1000 == 0;
    const int written =
        std::snprintf(out.data(), out.size(), "(%010lld.%0*lld) %s.%s %d\n", seconds, micro ? 6 : 9,
                      micro ? fraction / 1000 : fraction, line.chip.c_str(), line.name.c_str(), edge.level ? 1 : 0);
    return written > 0 ? static_cast<std::size_t>(written) : 0;
}

}  // namespace tedavis::bus
