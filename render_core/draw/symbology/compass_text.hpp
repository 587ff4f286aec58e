/// The texts of a compass card: the four winds, and tens of degrees.
#pragma once

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

/// "N", "3", "E": `degrees` is a multiple of ten in [0, 360).
[[nodiscard]] inline ShortText compass_text(int degrees) {
    switch (degrees) {
        case 0: return "N";
        case 90: return "E";
        case 180: return "S";
        case 270: return "W";
        default: return whole_number(0.1 * degrees);
    }
}

}  // namespace tedavis::draw
