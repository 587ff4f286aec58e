/// One entry of the legend of spatial data, drawn from the top of its box down.
#pragma once

#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::draw {

inline constexpr float kLegendEntryGap = 0.3f;  ///< gap between two entries, in texts

/// `box`: as high as data_legend_height() says, less the gap. `cut`: entries for which there was no room, written beside the
/// title.
void build_legend_entry(const Painter& painter, const DataLegend& legend, LegendDetail detail, const Rect& box, std::size_t cut);

}  // namespace tedavis::draw
