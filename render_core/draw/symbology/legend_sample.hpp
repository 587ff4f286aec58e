/// Small boxes that look as the shaders' techniques do, for legends.
#pragma once

#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::draw {

/// Inside `box`, with a frame round it.
void build_sample(const Painter& painter, const LegendSample& sample, const Rect& box);

}  // namespace tedavis::draw
