/// A moving vertical scale with its label, its rolling readout and its marks: airspeed and altitude.
///
/// In the box stand from the top: the selected value where there is one, the label, the scale, and the minimum of an approach
/// where there is one. The readout's pointer touches the edge from which the ticks go inwards; no number of the scale is written
/// where the readout covers a part of it. A failed value is replaced by a red cross; the rows of the selected value and of the
/// minimum stay.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/rolling_digits.hpp"
#include "render_core/draw/symbology/tape_marks.hpp"

namespace tedavis::draw {

struct VerticalTape {
    Rect box;
    double value = 0;        ///< display units, finite
    double lowest = 0;       ///< where the scale ends
    double span = 100;       ///< units over the whole height
    double minor_step = 10;  ///< a tick
    int majors = 2;          ///< every how many minor ticks a number stands
    int emphasis = 0;        ///< every how many minor ticks a tick is bold, and twice as bold at every second of them; 0: none
    RollingFormat readout;
    bool ticks_right = false;  ///< ticks on the right edge of the box, numbers left of them; else the other way round
    std::string_view label;    ///< source and unit
    std::string_view failure;  ///< in place of a failed value
    policy::ElementShow show = policy::ElementShow::normal;
    TapeRow selected, minimum;
    TapeMarks marks;
};

/// Nothing where the value is absent.
void build_vertical_tape(const Painter& painter, const VerticalTape& tape);

/// Boxes of the rows, and the scale in what they leave.
struct TapeLayout {
    Rect selected, label, minimum;
    TapeScale scale;
    Rect readout;            ///< in the middle of the scale; its pointer reaches out of it
    Rect stale;              ///< below the readout
    bool has_flags = false;  ///< there is room for them
};
[[nodiscard]] TapeLayout tape_layout(const Painter& painter, const VerticalTape& tape) noexcept;

/// Cuts a row off the top of a box.
[[nodiscard]] Rect take_top(Rect& box, float height) noexcept;

}  // namespace tedavis::draw
