/// The scale of the terrain's colors as legends write it. Pure; any thread.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

/// The ends of the scale, and how they are written.
struct TerrainScale {
    double low = 0, high = 0;  ///< in the palette's unit
    double factor = 1;         ///< written number of one of it
    std::string_view unit;
};
/// Of the values on the terrain, or of the palette's own ends where those are not known.
[[nodiscard]] TerrainScale terrain_scale(const LegendInput& legend) noexcept;

}  // namespace tedavis::draw
