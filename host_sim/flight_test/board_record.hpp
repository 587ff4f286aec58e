/// The record of one frame of a running display (target/record_line.hpp), as expectations see it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

struct BoardRecord {
    std::uint64_t frame = 0;
    double monotonic_s = 0;  ///< CLOCK_MONOTONIC of the board: the time for which the frame was planned
    /// Latency of the oldest bus frame that is first shown in this frame; nothing: it shows no new one
    std::optional<double> can_to_screen_s;
    bool is_on_screen = true;  ///< false: the display hardware has not confirmed that the picture was shown
    ObservedFrame seen;        ///< without time_s, latency_frames, has_obstacles and words
};

/// Parses a packet of the record socket. `display` is the path of the socket, for messages. Throws UserError where the packet is
/// no record, or lacks keys.
[[nodiscard]] BoardRecord read_board_record(std::string_view packet, std::string_view display);

/// Whether a condition can be judged by such a record, which has no texts, no picture, and no statement whether there are
/// obstacles.
[[nodiscard]] bool is_in_board_record(const FrameCondition& condition);

}  // namespace tedavis::host_sim
