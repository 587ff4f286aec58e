/// The user's options for the rasters of a terrain database.
#pragma once

#include <optional>
#include <string>

namespace tedavis::host_sim {

/// The reference of heights: the EGM96 geoid (mean sea level) or the WGS84 ellipsoid.
enum class VerticalDatum { egm96, ellipsoid };

/// Codes of heights in colours, with R, G and B from 0 to 255.
///   terrain_rgb: -10000 m + (R * 65536 + G * 256 + B) * 0.1 m (Mapbox, "Terrain-RGB" tileset documentation)
///   terrarium:   (R * 256 + G + B / 256) m - 32768 m (Mapzen, "Terrain Tiles" documentation)
enum class HeightEncoding { terrain_rgb, terrarium };

struct GeoBounds {
    double west_deg = 0, south_deg = 0, east_deg = 0, north_deg = 0;
};

/// Outer edges of a raster, in units of its coordinate system.
struct MapExtent {
    double west = 0, south = 0, east = 0, north = 0;
};

struct RasterOptions {
    std::optional<std::string> crs;               ///< overrides the files' own, e.g. "EPSG:21781"
    std::optional<MapExtent> extent;              ///< of the one file that is not georeferenced; degrees without `crs`
    std::optional<GeoBounds> bounds;              ///< posts outside are left out
    std::optional<double> void_value;             ///< an additional value that means "no height"
    std::optional<VerticalDatum> vertical_datum;  ///< nothing: as each file states, else EGM96
    std::optional<HeightEncoding> encoding;       ///< of the files that are colour pictures
};

/// Heights outside this range, metres, are void: no land has them, but undeclared void values do.
inline constexpr double kLowestHeight_m = -500, kHighestHeight_m = 9000;

}  // namespace tedavis::host_sim
