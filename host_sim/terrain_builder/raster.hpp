/// Rasters of any kind that GDAL reads, as one geographic lattice of posts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

enum class VerticalDatum { egm96, ellipsoid };

struct GeoBounds {
    double west_deg = 0, south_deg = 0, east_deg = 0, north_deg = 0;
};

struct RasterOptions {
    std::optional<std::string> crs;    ///< overrides the files' own, e.g. "EPSG:21781"
    std::optional<GeoBounds> bounds;   ///< posts outside are left out
    std::optional<double> void_value;  ///< an additional value that means "no height"
    VerticalDatum vertical_datum = VerticalDatum::egm96;
};

/// Heights outside count as void: no land lies there, and marks that a file does not declare do.
inline constexpr double kLowestHeight_m = -500, kHighestHeight_m = 9000;

/// Heights above MSL (EGM96), row 0 in the north. Void posts hold NaN. Longitudes grow beyond 180 where the raster
/// crosses the antimeridian.
struct Raster {
    std::uint32_t columns = 0, rows = 0;
    double west_deg = 0, north_deg = 0, step_lon_deg = 0, step_lat_deg = 0;
    std::vector<float> height_m;
    std::vector<terrain::PostClass> post_class;
    std::string source;
    bool resampled = false;  ///< posts were interpolated from another grid
    std::uint64_t void_posts = 0;
    std::vector<std::string> notes;  ///< sentences that the user should read

    [[nodiscard]] std::size_t at(std::uint32_t i, std::uint32_t j) const { return std::size_t{j} * columns + i; }
};

/// Posts of one geographic file are taken as they are; several files or another projection are interpolated bilinearly on
/// the finest geographic step of them. Heights in feet become metres. Sea is where a height above MSL is exactly zero.
/// Throws UserError.
[[nodiscard]] Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options);

}  // namespace tedavis::host_sim
