/// The input of a flight test as what is due when: frames of the bus, and edges of the panel.
#pragma once

#include <cstdint>
#include <vector>

#include "bus/frame/can_frame.hpp"
#include "bus/switches/switch_edge.hpp"
#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

struct TimedInput {
    std::vector<bus::CanFrame> frames;   ///< their times count from the first one's
    std::vector<bus::SwitchEdge> edges;  ///< after the first frame, likewise
    bool throws_panel = false;
    std::uint32_t first_levels = 0;  ///< of the panel's lines, a bit a line, at the first frame

    [[nodiscard]] double end_s() const { return frames.back().time.ns / 1e9; }
};

/// Reads logs as a replay does. Frames that a sender cannot repeat (error frames) are left out. Throws UserError where a log has
/// no frame, or names none of the panel's lines.
[[nodiscard]] TimedInput read_timed_input(const PlayerFiles& files, const bus::SwitchConfig& panel);

/// The pattern that leaves the phase to the other sources, else no line.
[[nodiscard]] std::uint32_t resting_levels(const bus::SwitchConfig& panel);

}  // namespace tedavis::host_sim
