/// The lattice of longitude and latitude for several rasters, or for one of another projection.
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

/// Returns the area of a source, to the outer edges of its pixels; east may be beyond 180. Throws UserError where the source
/// cannot be brought to WGS84.
[[nodiscard]] GeoBounds area_of(const RasterSource& source);

/// Returns the lattice of all sources within the bounds of the options, with the finest step of them in each direction, aligned
/// with the posts of the first plain one. Throws UserError where a source cannot be brought to WGS84.
[[nodiscard]] GeoLattice plan_lattice(const std::vector<RasterSource>& sources, const RasterOptions& options);

}  // namespace tedavis::host_sim
