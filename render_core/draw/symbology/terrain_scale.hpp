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

/// The number that is written for a metre, and its unit.
[[nodiscard]] double per_metre(design::HeightUnit unit) noexcept;
[[nodiscard]] std::string_view height_unit_text(design::HeightUnit unit) noexcept;

}  // namespace tedavis::draw
