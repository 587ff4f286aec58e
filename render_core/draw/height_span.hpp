/// The span of heights that the codes of a terrain picture divide (color_table.hpp). Plain data.
#pragma once

namespace tedavis::draw {

/// The range of heights above MSL that codes cover.
struct HeightSpan {
    double lowest_m = 0, highest_m = 0;
};

}  // namespace tedavis::draw
