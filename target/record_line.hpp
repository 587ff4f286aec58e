/// The record of one frame as JSON, for programs that watch a running display.
///
/// Keys and values are those of `frames.jsonl`, which `tedavis replay` writes, as far as a tester asks for them; beside them
/// stands what only a board knows: when the picture was on the screen; the instant of the machine's monotonic clock, which other
/// programs read, too; and the values of the signals.
#pragma once

#include <array>
#include <optional>

#include "render_core/display/planner/frame_record.hpp"
#include "target/json_line.hpp"

namespace tedavis::target {

/// How a frame came to be seen.
struct FrameDelivery {
    base::Time run_begun;       ///< `time_s` counts from here; the monotonic clock's
    base::Duration took;        ///< of planning and drawing
    bool is_warm = false;       ///< every design of the display has been drawn, so that a change of phase compiles nothing
    bool is_on_screen = false;  ///< false: unplugged, taken away, or not confirmed yet; off-screen always true
    std::optional<base::Duration>
        can_to_screen;  ///< of the oldest bus frame that is first seen in it; nothing: it holds no new one
    std::array<double, flight::kSignalCount> values{};  ///< of the signals that the display was given, SI; NaN: none
};

/// The values of a state, as FrameDelivery has them.
[[nodiscard]] std::array<double, flight::kSignalCount> values_of(const flight::AircraftState& state);

/// Writes the record in place of what stands in `line`.
void write_record(const display::FrameRecord& record, const FrameDelivery& delivery, JsonLine& line);

}  // namespace tedavis::target
