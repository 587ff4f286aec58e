/// The span of heights in codes of a terrain picture (color_table.hpp). Plain data.
#pragma once

namespace tedavis::draw {

/// The range of heights above MSL that codes cover.
struct HeightSpan {
    double lowest_m = 0, highest_m = 0;
};

}  // namespace tedavis::draw
