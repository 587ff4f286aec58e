/// Several rasters, or one of another projection, on one lattice of longitude and latitude.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/raster_source.hpp"

namespace tedavis::host_sim {

/// First post in the north-west; longitudes grow beyond 180 where the lattice crosses the antimeridian.
struct GeoLattice {
    double west_deg = 0, north_deg = 0, step_lon_deg = 0, step_lat_deg = 0;
    std::int64_t columns = 0, rows = 0;
};

/// The lattice of all sources within the bounds of the options, as fine as the finest of them in each direction and on
/// the posts of the first plain one. Throws UserError where a source cannot be brought to WGS84.
[[nodiscard]] GeoLattice plan_lattice(const std::vector<RasterSource>& sources, const RasterOptions& options);

/// Bilinear heights at the lattice's posts, NaN where no source has one; where sources overlap, the later one counts.
[[nodiscard]] std::vector<float> warp_heights(const std::vector<RasterSource>& sources, const GeoLattice& lattice,
                                              const RasterOptions& options);

}  // namespace tedavis::host_sim
