/// One height file as GDAL opens it: where its posts lie, how its numbers become metres, and above what.
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
    std::optional<HeightEncoding> encoding;  ///< heights stand in its colours
    /// North-up on a lattice of WGS84 longitude and latitude, to a hundredth of a post: posts can be taken as they are.
    bool plain = false;
    bool placed_by_options = false;  ///< it does not say itself where it lies
    std::vector<std::string> notes;  ///< sentences that the user should read
};

/// Columns and rows of pixels, first ones and counts.
struct PostWindow {
    int i = 0, j = 0, columns = 0, rows = 0;
};

/// Opens a raster (see open_raster_file). Throws UserError for what is no height raster with a place on Earth: no
/// raster, not georeferenced, no or an unknown coordinate system, a colour picture, what says that it holds another
/// quantity, values that are no lengths, depths, a
/// vertical datum that contradicts the options.
[[nodiscard]] RasterSource open_raster_source(const std::string& file, const RasterOptions& options);

/// Heights in metres above the file's datum, row by row; NaN where the file or the options mark a void and where a value
/// lies outside kLowestHeight_m..kHighestHeight_m. Throws UserError where the file is damaged.
[[nodiscard]] std::vector<float> read_heights(const RasterSource& source, const PostWindow& window, const RasterOptions& options);

/// WGS84 longitude and latitude, in this order.
[[nodiscard]] OGRSpatialReference wgs84_longitude_latitude();

}  // namespace tedavis::host_sim
