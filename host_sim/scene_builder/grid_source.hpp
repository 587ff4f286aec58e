/// A variable of a raster file as planes over one lattice: times, levels and members of what GDAL calls bands.
///
/// Reads GeoTIFF, netCDF, GRIB 1 and 2, HDF5 and whatever else GDAL does. A lattice that is not in longitude and latitude is
/// warped to it. Geographic systems on other ellipsoids or spheres are taken as WGS84, as usual for weather data. Rows run from
/// north to south and columns from west to east, whatever the file's order; longitudes of 0..360 become -180..180.
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
    std::optional<double> level;                   ///< pressures in hPa, others as the file states them
    std::optional<std::int64_t> computed_ns = {};  ///< a forecast's reference time
    std::string variable = {};                     ///< its name, where a band states one (GRIB, netCDF)
};

/// Texts of the file about a plane; empty where it has none.
struct PlaneTexts {
    std::string description, unit;              ///< of its values
    std::string level_unit, level_kind;         ///< "hPa", "Isobaric surface"
    std::optional<double> missing, undetected;  ///< numbers by which radar composites (ODIM) mean "no value", "no echo"
};

/// Degrees; of posts, which are pixels' centres.
struct GridPlaces {
    double west_deg = 0, north_deg = 0, step_lon_deg = 1, step_lat_deg = 1;
    int columns = 0, rows = 0;
};

class GridSource {
public:
    /// `variable`: of a file with several; "band 2" for one band; empty or of a file with one variable: all bands. `crs`: for
    /// files that state none. Throws UserError where there is no such raster or it has no place on the Earth.
    GridSource(const std::string& file, const std::string& variable, const std::string& crs, bool may_blend);

    [[nodiscard]] const GridPlaces& places() const { return places_; }
    [[nodiscard]] const std::vector<GridPlane>& planes() const { return planes_; }
    /// Returns the values with scale and offset applied, row by row; NaN where a number or a mask of the file marks a missing
    /// value.
    [[nodiscard]] std::vector<float> read(const GridPlane& plane) const;
    /// True where neither file nor recipe names a reference system or its units, and the file's numbers can be degrees.
    [[nodiscard]] bool is_assumed() const { return is_assumed_; }
    /// As the file states it; may be empty.
    [[nodiscard]] const std::string& unit() const { return unit_; }
    [[nodiscard]] PlaneTexts texts_of(const GridPlane& plane) const;
    /// The reference system as the file or `crs` states it; empty where neither does.
    [[nodiscard]] const std::string& system() const { return system_; }
    /// GDAL's name of the file's format.
    [[nodiscard]] const std::string& format() const { return format_; }
    /// True if the file has another coordinate system, so that its values are interpolated in longitude and latitude.
    [[nodiscard]] bool is_warped() const { return unwarped_ != nullptr; }

private:
    void open(const std::string& file, const std::string& variable);
    void warp_to_longitude_latitude(const std::string& crs, bool may_blend);
    void read_places();
    void list_planes(const std::string& variable);
    void keep_variable(const std::string& variable);
    [[nodiscard]] GDALDataset& stating() const { return unwarped_ != nullptr ? *unwarped_ : *dataset_; }

    std::string file_;
    GdalDataset container_, unwarped_, dataset_;  ///< later ones need earlier ones
    GridPlaces places_;
    bool flips_rows_ = false, flips_columns_ = false, is_assumed_ = false;
    std::vector<GridPlane> planes_;
    std::string unit_, system_, format_;
};

/// The variables of a file that keeps each in a raster of its own (netCDF, HDF5), as GridSource and scene files name them. Empty
/// for other files: their bands state the variables, or are known by their numbers. Throws UserError where it is no raster.
[[nodiscard]] std::vector<std::string> rasters_inside(const std::string& file);

}  // namespace tedavis::host_sim
