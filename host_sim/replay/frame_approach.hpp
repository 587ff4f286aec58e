/// Shows the display what came before a frame, so that the frame is the same however it is reached.
///
/// What has arrived of the terrain follows from the frames of a short window. A frame that follows the last one in time needs
/// nothing; before any other the frames of the window before it are planned again. Where the run begins within the window, its
/// first frame stands for what lies before it.
#pragma once

#include <optional>

#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_instants.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::host_sim {

class FrameApproach {
public:
    FrameApproach(FlightPlayer& player, display::Display& display, const FrameInstants& instants)
        : player_(player), display_(display), instants_(instants) {}

    /// `n` in order of time. Call before the frame is drawn.
    void approach(std::uint64_t n);

private:
    /// Once, and so many times again.
    void plan(base::Time time, std::uint64_t again);

    FlightPlayer& player_;
    display::Display& display_;
    const FrameInstants& instants_;
    std::optional<std::uint64_t> last_;
};

}  // namespace tedavis::host_sim
