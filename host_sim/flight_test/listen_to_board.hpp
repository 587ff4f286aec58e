/// Records the bus of a running display and the display's frames, from which a flight test is written.
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
    /// Frames before this time are skipped, since they still show what was received before the first bus frame.
    double from_s = 0;
    std::function<bool()> is_interrupted;
    std::function<void(double done_s)> told;  ///< may be empty; below 0: before the first frame
};

struct HeardFlight {
    std::vector<bus::CanFrame> frames;  ///< stamps of CLOCK_MONOTONIC
    std::uint64_t shown = 0;            ///< number of the display's frames that `tracks` took
};

/// `tracks` takes the display's frames, with times since the first bus frame, up to the last bus frame. Throws UserError where no
/// bus frame is received in the first ten seconds, the kernel has dropped bus frames, records are missing, a frame is not on the
/// screen, or the panel states the phase, whose edges cannot be recorded; BoardLost; and Interrupted.
[[nodiscard]] HeardFlight listen_to_board(BoardPort& port, const ListenSettings& settings, FactTracks& tracks);

}  // namespace tedavis::host_sim
