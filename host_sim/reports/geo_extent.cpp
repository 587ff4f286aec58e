#include "host_sim/reports/geo_extent.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

void GeoExtent::include(double latitude_deg, double longitude_deg) {
    south_deg = std::min(south_deg, latitude_deg);
    north_deg = std::max(north_deg, latitude_deg);
    west_deg = std::min(west_deg, longitude_deg);
    east_deg = std::max(east_deg, longitude_deg);
}

std::string GeoExtent::words() const {
    return decimal(south_deg, 3) + " .. " + decimal(north_deg, 3) + " N, " + decimal(west_deg, 3) + " .. " +
           decimal(east_deg, 3) + " E";
}

GeoExtent extent_of(const terrain::TerrainDatabase& database) {
    const terrain::Lattice& lattice = database.lattice();
    const terrain::FileHeader& header = database.header();
    return {base::degrees(lattice.latitude_rad(lattice.rows() - 1)), base::degrees(lattice.latitude_rad(0)), header.west_deg,
            header.west_deg + header.step_lon_deg * (header.columns - 1)};
}

GeoExtent extent_of(const scene::Scene& scene) {
    GeoExtent extent;
    for (const scene::Layer& layer : scene.layers()) {
        for (const scene::ScenePoint& point : layer.points)
            extent.include(base::degrees(point.latitude_rad), base::degrees(point.longitude_rad));
        const scene::GridShape& grid = layer.entry->grid;
        if (grid.columns == 0 || grid.rows == 0) continue;
        extent.include(base::degrees(grid.north_rad), base::degrees(grid.west_rad));
        extent.include(base::degrees(grid.north_rad - grid.step_lat_rad * (grid.rows - 1)),
                       base::degrees(grid.west_rad + grid.step_lon_rad * (grid.columns - 1)));
    }
    return extent;
}

bool are_apart(const GeoExtent& a, const GeoExtent& b, double degrees) {
    if (a.is_empty() || b.is_empty()) return false;
    const double between_latitudes = std::max(a.south_deg - b.north_deg, b.south_deg - a.north_deg);
    if (between_latitudes > degrees) return true;
    // The same meridian has many names.
    for (const double turn : {-360.0, 0.0, 360.0})
        if (std::max(a.west_deg - b.east_deg - turn, b.west_deg + turn - a.east_deg) <= degrees) return false;
    return true;
}

}  // namespace tedavis::host_sim
