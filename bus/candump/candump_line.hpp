/// Parses and formats one line of a candump log (`candump -l`, `-L`).
///
/// Forms (can-utils lib.h): `(seconds.fraction) interface frame[ R| T]` with 6 or 9 fractional digits and any number of
/// blanks before the interface; frame is `123#data`, `12345678#data`, `123#R[length]`, `..._D` with a raw length code 9..F
/// after eight bytes, `123##F data` for CAN FD with one flag nibble; bytes may be separated by dots. Eight digits with
/// bit 29 set are an error frame. CAN XL lines are refused by name.
///
/// Thread  any. Memory  none. Failure  the line has the kind `malformed` and a fault; its frame must not be used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

enum class LineKind : std::uint8_t {
    frame,
    blank,
    drop_report,  ///< `DROPCOUNT: dropped N CAN frames on 'IF' socket ...`
    other,        ///< does not start with '(': text that candump's own player ignores as well
    malformed,    ///< starts like a frame but is not a valid one
};

enum class LineFault : std::uint8_t {
    none,
    time_stamp,
    interface_name,
    identifier,
    data,
    length,
    fd_flags,
    raw_length_code,
    can_xl,
    trailing_text,
    too_long,
};
/// Returns the fault as the end of a sentence: "the time stamp is not (seconds.6 or 9 digits)".
[[nodiscard]] const char* describe(LineFault fault) noexcept;

/// Later stamps (after the year 2255) are refused, so that sums of times and durations never overflow int64.
inline constexpr base::Time kLatestStamp{9'000'000'000'000'000'000};

struct CandumpLine {
    LineKind kind = LineKind::malformed;
    LineFault fault = LineFault::none;
    std::uint32_t dropped = 0;        ///< drop reports: frames lost since the previous report
    std::string_view interface_name;  ///< frames: points into the line
};

/// Parses a line without its newline; a carriage return and blanks at its end are allowed. `frame` is complete when the kind is
/// `frame`, otherwise unspecified; its channel is left 0.
[[nodiscard]] CandumpLine parse_candump_line(std::string_view line, CanFrame& frame) noexcept;

enum class StampDigits : std::uint8_t { micro = 6, nano = 9 };

/// A line with its newline is never longer than this.
inline constexpr std::size_t kMaxCandumpLine = 256;

/// Writes the line with a newline at its end and returns its length; 0 when `out` is shorter than kMaxCandumpLine, the
/// time is negative or the interface name is not 1..15 characters. With `direction` the suffix ` R` or ` T` is added.
/// Micro stamps cut the digits below the microsecond, as candump does.
[[nodiscard]] std::size_t format_candump_line(const CanFrame& frame, std::string_view interface_name, StampDigits digits,
                                              bool direction, base::Span<char> out) noexcept;

}  // namespace tedavis::bus
