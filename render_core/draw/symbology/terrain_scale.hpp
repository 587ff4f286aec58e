/// The scale of the terrain's colours as legends write it. Pure; any thread.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

/// The ends of the scale, and how they are written.
struct TerrainScale {
    double low = 0, high = 0;  ///< in the palette's unit
    double factor = 1;         ///< displayed units per unit of the palette
    std::string_view unit;
};
/// Returns the scale of the values on the terrain, or of the palette's own ends where these values are not known.
[[nodiscard]] TerrainScale terrain_scale(const LegendInput& legend) noexcept;

}  // namespace tedavis::draw
