/// Lists the variables of a raster file with name, quantity and unit as the file states them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::host_sim {

struct GridVariable {
    std::string name;  ///< as `variable` of a scene file names it: "u", "band 1"
    std::string
        quantity;      ///< "eastward_wind", "UGRD", "DBZH": standard name, GRIB element or ODIM quantity; else as it is described
    std::string unit;  ///< as the file states it; may be empty
    bool has_levels = false;
    std::optional<std::int64_t> first_ns, last_ns;  ///< times that are stated of its planes
    std::optional<double> missing, undetected;      ///< numbers of ODIM files, which are no values
};

/// In the file's order. Bands of one GRIB element or netCDF variable are one variable; other bands are one each. Throws UserError
/// where GDAL reads no raster.
[[nodiscard]] std::vector<GridVariable> grid_variables(const std::string& file);

}  // namespace tedavis::host_sim
