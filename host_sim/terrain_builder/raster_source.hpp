/// One height file opened with GDAL: the position of its posts, the unit of its numbers, and their datum.
#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

struct RasterSource {
    std::string file;
    GdalDataset dataset;  ///< may be closed while it is not read; open_raster_file opens it again
    int columns = 0, rows = 0;
    OGRSpatialReference crs;            ///< horizontal; longitude or easting first
    std::array<double, 6> transform{};  ///< GDAL's: pixel corner to coordinates of `crs`
    double metres_per_count = 1, offset_m = 0;
    VerticalDatum datum = VerticalDatum::egm96;
    std::optional<HeightEncoding> encoding;  ///< code of heights in its colours; nothing: the values are heights
    /// North-up on a lattice of WGS84 longitude and latitude, to a hundredth of a post, so that its posts are used without
    /// interpolation.
    bool plain = false;
    bool placed_by_options = false;  ///< the file is not georeferenced
    std::vector<std::string> notes;  ///< sentences that the user should read
};

/// A window of pixels: first column and row, and counts.
struct PostWindow {
    int i = 0, j = 0, columns = 0, rows = 0;
};

/// Opens a raster (see open_raster_file). Throws UserError for a file that is no height raster: no raster, not georeferenced, no
/// or an unknown coordinate system, a colour picture, another stated quantity, values that are no lengths, depths, or a vertical
/// datum that contradicts the options.
[[nodiscard]] RasterSource open_raster_source(const std::string& file, const RasterOptions& options);

/// Returns heights in metres above the file's datum, row by row; NaN where the file or the options mark a void or the value is
/// outside kLowestHeight_m..kHighestHeight_m. Throws UserError where the file is damaged.
[[nodiscard]] std::vector<float> read_heights(const RasterSource& source, const PostWindow& window, const RasterOptions& options);

/// WGS84 longitude and latitude, in this order.
[[nodiscard]] OGRSpatialReference wgs84_longitude_latitude();

}  // namespace tedavis::host_sim
