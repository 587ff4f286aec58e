#include "render_core/draw/symbology/terrain_scale.hpp"

#include "render_core/base/units.hpp"

namespace tedavis::draw {

TerrainScale terrain_scale(const LegendInput& legend) noexcept {
    const auto& stops = legend.palette.stops;
    TerrainScale scale{legend.lowest, legend.highest, 1, ""};
    if (!(scale.high > scale.low)) scale = {stops[0].value, stops.back().value, 1, ""};
    switch (legend.palette.unit) {
        case design::PaletteUnit::metres:
            scale.factor = base::height_unit(legend.units).of(1);
            scale.unit = base::height_unit(legend.units).text;
            break;
        case design::PaletteUnit::degrees:
            scale.factor = base::degrees(1);
            scale.unit = "DEG";
            break;
        default: break;  // no quantity of the terrain has another
    }
    return scale;
}

}  // namespace tedavis::draw
