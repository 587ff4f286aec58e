/// A moving vertical scale with its readout and label: airspeed and altitude.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

struct VerticalTape {
    Rect box;
    double value = 0;          ///< display units, finite
    double lowest = 0;         ///< where the scale ends
    double span = 100;         ///< units over the whole height
    double minor_step = 10;    ///< a tick
    int majors = 2;            ///< every how many minor ticks a number stands
    double readout_step = 1;   ///< the readout is rounded to it
    bool ticks_right = false;  ///< ticks on the right edge of the box, numbers left of them; else the other way round
    std::string_view label;    ///< source and unit
    policy::ElementShow show = policy::ElementShow::normal;
};

void build_vertical_tape(const Painter& painter, const VerticalTape& tape);

}  // namespace tedavis::draw
