/// Text by a format of printf, for a line of a report.
#pragma once

#include <cstdio>
#include <string>

namespace tedavis::host_sim {

/// Longest text, bytes; longer ones are truncated.
inline constexpr int kMaxPrinted = 511;

template <class... Values>
[[nodiscard]] std::string printed(const char* format, Values... values) {
    char text[kMaxPrinted + 1];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace tedavis::host_sim
