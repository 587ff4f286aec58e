/// Sample boxes of legends, which look as the shaders draw the techniques.
#pragma once

#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::draw {

inline constexpr float kSampleWidth = 1.2f;  ///< texts
inline constexpr int kBarSlices = 32;        ///< number of slices of a continuous scale
inline constexpr float kUnder_px = 1;        ///< overlap of a slice with its neighbour
inline constexpr int kMaxNumbers = 16;       ///< largest number of numbers at a scale

/// Inside `box`, with a frame round it.
void build_sample(const Painter& painter, const LegendSample& sample, const Rect& box);

}  // namespace tedavis::draw
