/// The lattice of a terrain's posts, and their sources.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

/// Degrees; row 0 in the north. Longitudes grow beyond 180 where the lattice crosses the antimeridian.
struct PostGrid {
    std::uint32_t columns = 0, rows = 0;
    double west_deg = 0, north_deg = 0;  ///< of the north-west post
    double step_lon_deg = 0, step_lat_deg = 0;
    std::string source;  ///< names of the files, without folders
    /// Datum of the files: ellipsoid if all of them have ellipsoidal heights. Heights of posts are always above MSL.
    VerticalDatum vertical_datum = VerticalDatum::egm96;
};

}  // namespace tedavis::host_sim
