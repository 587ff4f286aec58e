/// The input of a flight test as a schedule: frames of the bus and edges of the panel with their times.
#pragma once

#include <cstdint>
#include <vector>

#include "bus/frame/can_frame.hpp"
#include "bus/switches/switch_edge.hpp"
#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

struct TimedInput {
    std::vector<bus::CanFrame> frames;   ///< times since the first frame
    std::vector<bus::SwitchEdge> edges;  ///< those after the first frame, with times since it
    bool throws_panel = false;
    std::uint32_t first_levels = 0;  ///< levels of the panel's lines at the first frame, one bit per line

    [[nodiscard]] double end_s() const { return frames.back().time.ns / 1e9; }
};

/// Reads logs as a replay does. Error frames, which a sender cannot repeat, are left out. Throws UserError where the log has no
/// frame, or the switch log none of the panel's lines.
[[nodiscard]] TimedInput read_timed_input(const PlayerFiles& files, const bus::SwitchConfig& panel);

/// The panel's pattern that leaves the phase to the other sources; all lines inactive where it has none.
[[nodiscard]] std::uint32_t resting_levels(const bus::SwitchConfig& panel);

}  // namespace tedavis::host_sim
