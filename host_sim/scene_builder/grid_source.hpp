/// A variable of a raster file as planes over one lattice: times, levels and members of what GDAL calls bands.
///
/// Reads GeoTIFF, netCDF, GRIB 1 and 2, HDF5 and whatever else GDAL does. A lattice that is not in longitude and latitude is
/// warped to it. Geographic systems on other ellipsoids or spheres count as WGS84, as weather data mean them. Rows run from north
/// to south and columns from west to east, whatever the file's order; longitudes of 0..360 become -180..180.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/raster_file.hpp"

namespace tedavis::host_sim {

struct GridPlane {
    int band = 1;
    std::optional<std::int64_t> time_ns;
    std::optional<double> level;                   ///< as the file states it: hPa, m, ...
    std::optional<std::int64_t> computed_ns = {};  ///< a forecast's reference time
};

/// Degrees; of posts, which are pixels' centres.
struct GridPlaces {
    double west_deg = 0, north_deg = 0, step_lon_deg = 1, step_lat_deg = 1;
    int columns = 0, rows = 0;
};

class GridSource {
public:
    /// `variable`: of a file with several; "band 2" for one band; empty or the file's only variable: all bands. `crs`: for files
    /// that state none. Throws UserError where there is no such raster or it has no place on the Earth.
    GridSource(const std::string& file, const std::string& variable, const std::string& crs, bool may_blend);

    [[nodiscard]] const GridPlaces& places() const { return places_; }
    [[nodiscard]] const std::vector<GridPlane>& planes() const { return planes_; }
    /// Values with scale and offset applied, row by row; NaN where the file says that there is none, by a number or by a mask.
    [[nodiscard]] std::vector<float> read(const GridPlane& plane) const;
    /// True where neither file nor recipe names a reference system or its units, and the file's numbers can be degrees.
    [[nodiscard]] bool is_assumed() const { return is_assumed_; }
    /// As the file states it; may be empty.
    [[nodiscard]] const std::string& unit() const { return unit_; }

private:
    void open(const std::string& file, const std::string& variable);
    void warp_to_longitude_latitude(const std::string& crs, bool may_blend);
    void read_places();
    void list_planes(const std::string& variable);

    std::string file_;
    GdalDataset container_, unwarped_, dataset_;  ///< later ones need earlier ones
    GridPlaces places_;
    bool flips_rows_ = false, flips_columns_ = false, is_assumed_ = false;
    std::vector<GridPlane> planes_;
    std::string unit_;
};

}  // namespace tedavis::host_sim
