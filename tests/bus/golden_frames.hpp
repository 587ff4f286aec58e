/// Frames by their candump text, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "bus/candump/candump_line.hpp"

namespace tedavis::bus {

/// "137#0102002A40A00000" received at `ns`.
inline CanFrame frame_of(const std::string& content, std::int64_t ns = 0) {
    CanFrame frame;
    const CandumpLine line = parse_candump_line("(0000000000.000000) can0 " + content, frame);
    EXPECT_EQ(line.kind, LineKind::frame) << content << ": " << describe(line.fault);
    frame.time.ns = ns;
    return frame;
}

/// The part behind the interface name, as candump writes it.
inline std::string text_of(const CanFrame& frame) {
    CanFrame at_zero = frame;
    at_zero.time = {};
    char out[kMaxCandumpLine];
    const std::size_t size = format_candump_line(at_zero, "c", StampDigits::micro, false, out);
    constexpr std::size_t kBefore = sizeof("(0000000000.000000) c ") - 1;
    return size > kBefore ? std::string(out + kBefore, size - kBefore - 1) : std::string();
}

}  // namespace tedavis::bus
