/// The window's overlay over the picture of the display: short lines with time, speed and phase in the lower left corner, below
/// the shipped designs' boxes and beside their notices, and a panel with lines such as the list of keys. It is black on a light
/// background, unlike any symbology, and begins with the word WINDOW, so that nobody takes it for a part of the display. Pure: it
/// is painted over a finished frame (painted_rects.hpp) and is in no record.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/window/painted_rects.hpp"
#include "render_core/flight/flight_time.hpp"

namespace tedavis::host_sim {

/// The content of the lines. Times are seconds since the log's first frame.
struct HeadUp {
    double flight_s = 0, last_s = 0;
    flight::FlightTime time;  ///< shown if it has a date
    double speed = 1;
    bool is_backwards = false, is_playing = true;
    std::string phase, design, camera;  ///< `camera` is shown if it is not empty
};
[[nodiscard]] std::string head_up_text(const HeadUp& head_up);

struct WindowOverlay {
    std::string line;                ///< lines, separated by line breaks; empty: none
    std::vector<std::string> panel;  ///< lines; empty: none
};
/// Returns the rectangles in the order in which they are painted, inside a picture of this size; text that would not fit is
/// smaller.
[[nodiscard]] std::vector<PaintedRect> overlay_rects(const WindowOverlay& overlay, std::uint32_t width_px,
                                                     std::uint32_t height_px);

}  // namespace tedavis::host_sim
