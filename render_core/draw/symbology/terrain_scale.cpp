#include "render_core/draw/symbology/terrain_scale.hpp"

#include "render_core/base/units.hpp"

namespace tedavis::draw {

double per_metre(design::HeightUnit unit) noexcept { return unit == design::HeightUnit::feet ? 1 / base::kMetresPerFoot : 1; }

std::string_view height_unit_text(design::HeightUnit unit) noexcept { return unit == design::HeightUnit::feet ? "FT" : "M"; }

TerrainScale terrain_scale(const LegendInput& legend) noexcept {
    const auto& stops = legend.palette.stops;
    TerrainScale scale{legend.lowest, legend.highest, 1, ""};
    if (!(scale.high > scale.low)) scale = {stops[0].value, stops.back().value, 1, ""};
    switch (legend.palette.unit) {
        case design::PaletteUnit::metres:
            scale.factor = per_metre(legend.unit);
            scale.unit = height_unit_text(legend.unit);
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
