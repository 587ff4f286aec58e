/// The record of one frame of a running display (target/record_line.hpp), as expectations see it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

struct BoardRecord {
    std::uint64_t frame = 0;
    double monotonic_s = 0;                 ///< CLOCK_MONOTONIC of the machine: the instant that the frame was planned for
    std::optional<double> can_to_screen_s;  ///< of the oldest bus frame that is first seen in it; nothing: it holds no new one
    bool is_on_screen = true;               ///< false: the screen has not confirmed the picture, so nobody could see it
    ObservedFrame seen;                     ///< without its time, its latency, obstacles and words
};

/// `display`: its socket, for sentences. Throws UserError where the packet is no record, or that of a program which says too
/// little.
[[nodiscard]] BoardRecord read_board_record(std::string_view packet, std::string_view display);

/// Whether a record can answer a condition of an expectation: it has no texts and no picture, and does not say
/// whether there are obstacles.
[[nodiscard]] bool is_in_board_record(const FrameCondition& condition);

}  // namespace tedavis::host_sim
