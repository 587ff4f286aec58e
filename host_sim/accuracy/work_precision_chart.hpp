/// The work-precision chart of a knob as inline SVG: error over time, both on logarithmic scales, a mark for each level.
#pragma once

#include <string>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

/// Mean errors over medians of times, with a bar from the 5th to the 95th percentile of the times and a line up to the greatest
/// error. Marks differ by shape, not by colour alone: a disc for a level that is not dominated, a cross for a dominated one, a
/// ring for an alternative that the product does not offer, a square on the lower border for one without an error. A line joins
/// the discs.
[[nodiscard]] std::string work_precision_svg(const MeasuredKnob& knob);

/// A decade scale: the powers of ten that enclose all values above 0; one decade at least.
struct DecadeScale {
    int first = 0, last = 1;  ///< powers of ten at both ends

    static DecadeScale of(const std::vector<double>& values);
    /// 0 at the first power and 1 at the last one; values of 0 or below are at 0.
    [[nodiscard]] double place(double value) const;
};

}  // namespace tedavis::host_sim
