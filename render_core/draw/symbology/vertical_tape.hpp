/// A tape: a vertical scale that moves behind a fixed readout with rolling digits, with a label and marks. Used for airspeed and
/// altitude.
///
/// The box contains, from top to bottom, the selected value (if any), the label, the scale, and the minimum of the approach (if
/// any). The readout's pointer touches the edge from which the ticks go inwards. No number is written where the readout would
/// cover a part of it. A failed value is replaced by a red cross; the rows of the selected value and of the minimum stay.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/rolling_digits.hpp"
#include "render_core/draw/symbology/tape_marks.hpp"

namespace tedavis::draw {

struct VerticalTape {
    Rect box;
    double value = 0;        ///< display units, finite
    double lowest = 0;       ///< lowest value of the scale
    double span = 100;       ///< units over the whole height
    double minor_step = 10;  ///< units between two ticks
    int majors = 2;          ///< number of minor steps from one number to the next
    /// Minor steps between bold ticks (two strokes); every second bold tick has three strokes. 0: none.
    int emphasis = 0;
    RollingFormat readout;
    bool ticks_right = false;  ///< ticks on the right edge of the box, numbers left of them; else the other way round
    std::string_view label;    ///< source and unit
    std::string_view failure;  ///< text of the red cross
    policy::ElementShow show = policy::ElementShow::normal;
    TapeRow selected, minimum;
    TapeMarks marks;
};

/// Draws nothing if the value is absent.
void build_vertical_tape(const Painter& painter, const VerticalTape& tape);

/// Where the parts of a tape are placed; the scale takes the space that the rows leave free.
struct TapeLayout {
    Rect selected, label, minimum;
    TapeScale scale;
    Rect readout;            ///< in the middle of the scale; the pointer extends from it towards the ticks
    Rect stale;              ///< the flag STALE, below the readout
    bool has_flags = false;  ///< there are speed flags, and room for them
};
[[nodiscard]] TapeLayout tape_layout(const Painter& painter, const VerticalTape& tape) noexcept;

/// Removes a row from the top of the box and returns it.
[[nodiscard]] Rect take_top(Rect& box, float height) noexcept;

}  // namespace tedavis::draw
