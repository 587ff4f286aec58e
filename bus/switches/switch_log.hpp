/// Parses and formats the recorded switch log, a text of edges that accompanies a candump log.
///
///     # tedavis switch log 1
///     (1700000000.000000) panel.GROUND 1
///     (1700000000.000000) panel.TAKEOFF 0
///     (1700000061.250000) panel.GROUND 0
///     (1700000061.268500) panel.TAKEOFF 1
///
/// The first line is the header as above. An edge is `(seconds.fraction) chip.line level`: source time with 6 or 9
/// fractional digits, chip and line as the switch config names them, level 1 (active) or 0. Times never decrease. The
/// first edge of a line is its level at start, so a log begins with one edge for each line. Blank lines and lines that
/// begin with `#` are comments. A broken line is counted and skipped.
///
/// Thread  any. Memory  none. Failure  a kind and a reason, never a partly filled edge taken as whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

inline constexpr std::string_view kSwitchLogHeader = "# tedavis switch log 1\n";
/// True where the text begins with the header of this version; a text without it must be refused before edges are read.
[[nodiscard]] bool has_switch_log_header(std::string_view text) noexcept;

enum class SwitchLineKind : std::uint8_t { edge, comment, unknown_line, malformed };
enum class SwitchLineFault : std::uint8_t { none, time_stamp, line_name, level, time_runs_back };
/// Returns the fault as the end of a sentence: "the level is not 0 or 1".
[[nodiscard]] const char* describe(SwitchLineFault fault) noexcept;

struct SwitchLogLine {
    SwitchLineKind kind = SwitchLineKind::malformed;
    SwitchLineFault fault = SwitchLineFault::none;
    SwitchEdge edge;  ///< valid when the kind is `edge`
};

/// `line` without its newline; a carriage return and blanks at its end are allowed.
[[nodiscard]] SwitchLogLine parse_switch_log_line(std::string_view line, const SwitchConfig& config) noexcept;

/// A line with its newline is never longer than this.
inline constexpr std::size_t kMaxSwitchLogLine = 192;
/// Writes the edge with a newline at its end and returns its length; 0 when `out` is shorter than kMaxSwitchLogLine, the
/// time is negative or the config has no such line. Six fractional digits where they are exact, else nine.
[[nodiscard]] std::size_t format_switch_log_line(const SwitchEdge& edge, const SwitchConfig& config,
                                                 base::Span<char> out) noexcept;

}  // namespace tedavis::bus
