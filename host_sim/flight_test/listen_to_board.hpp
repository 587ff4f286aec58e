/// Listens to a running display: what its bus says, and what it shows, for a flight test that expects it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bus/frame/can_frame.hpp"
#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/recorded_facts.hpp"

namespace tedavis::host_sim {

struct ListenSettings {
    std::string display;  ///< its socket, for sentences
    double for_s = 0;     ///< since the first frame of the bus
    double from_s = 0;    ///< what is shown before that still comes from what was sent before the first frame
    std::function<bool()> is_interrupted;
    std::function<void(double done_s)> told;  ///< may be empty; below 0: before the first frame
};

struct HeardFlight {
    std::vector<bus::CanFrame> frames;  ///< times of the monotonic clock
    std::uint64_t shown = 0;            ///< frames of the display that `tracks` took
};

/// The tracks take frames whose time 0 is the bus's first frame, and none that is later than the last one: a log ends there.
/// Throws UserError where the bus says nothing for ten seconds from the beginning, the kernel has
/// dropped frames of it, records are missing, a frame is not on the screen, or the panel states the phase, whose edges nobody can
/// hear; BoardLost; and Interrupted.
[[nodiscard]] HeardFlight listen_to_board(BoardPort& port, const ListenSettings& settings, FactTracks& tracks);

}  // namespace tedavis::host_sim
