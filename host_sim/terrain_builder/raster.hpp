/// Rasters of any kind that GDAL reads, as one geographic lattice of posts in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/raster_options.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// Heights above MSL (EGM96), row 0 in the north. Void posts hold NaN. Longitudes grow beyond 180 where the raster
/// crosses the antimeridian.
struct Raster {
    std::uint32_t columns = 0, rows = 0;
    double west_deg = 0, north_deg = 0, step_lon_deg = 0, step_lat_deg = 0;
    std::vector<float> height_m;
    std::vector<terrain::PostClass> post_class;
    VerticalDatum vertical_datum = VerticalDatum::egm96;  ///< of the files
    std::string source;
    bool resampled = false;  ///< posts were interpolated from another grid
    std::uint64_t void_posts = 0;
    std::vector<std::string> notes;  ///< sentences that the user should read

    [[nodiscard]] std::size_t at(std::uint32_t i, std::uint32_t j) const { return std::size_t{j} * columns + i; }
};

/// All posts of a PostSource; its rules hold. Throws UserError, also where there are more than 2^30 posts or only voids.
[[nodiscard]] Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options);

}  // namespace tedavis::host_sim
