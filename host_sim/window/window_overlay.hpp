/// What the window adds to the picture of the display: short lines with time, speed and phase in the lower left corner, below the
/// shipped designs' boxes and beside their notices, and a panel with lines such as the list of keys. It is black on light paper,
/// which no symbology is, and begins with the word WINDOW, so that nobody takes it for a part of the display. Pure: it is painted
/// over a finished frame (painted_rects.hpp) and is in no record.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/window/painted_rects.hpp"
#include "render_core/flight/flight_time.hpp"

namespace tedavis::host_sim {

/// What the lines say. Seconds since the log's first frame.
struct HeadUp {
    double flight_s = 0, last_s = 0;
    flight::FlightTime time;  ///< said where it is a date
    double speed = 1;
    bool is_backwards = false, is_playing = true;
    std::string phase, design, camera;  ///< the camera is said where it is not empty
};
[[nodiscard]] std::string head_up_text(const HeadUp& head_up);

struct WindowOverlay {
    std::string line;                ///< lines, parted by line breaks; empty: none
    std::vector<std::string> panel;  ///< lines; empty: none
};
/// In the order in which they are painted, inside a picture of this size; text is smaller where it would not fit.
[[nodiscard]] std::vector<PaintedRect> overlay_rects(const WindowOverlay& overlay, std::uint32_t width_px,
                                                     std::uint32_t height_px);

}  // namespace tedavis::host_sim
