/// Small boxes that look as the shaders' techniques do, for legends.
#pragma once

#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::draw {

inline constexpr float kSampleWidth = 1.2f;  ///< texts
inline constexpr int kBarSlices = 32;        ///< that a continuous scale is painted in
inline constexpr float kUnder_px = 1;        ///< by which a slice reaches under its neighbour
inline constexpr int kMaxNumbers = 16;       ///< at a scale

/// Inside `box`, with a frame round it.
void build_sample(const Painter& painter, const LegendSample& sample, const Rect& box);

}  // namespace tedavis::draw
