/// Height files as GDAL opens them: alone, inside a zip archive, or one of several grids in a file.
#pragma once

#include <gdal_priv.h>

#include <memory>
#include <string>
#include <vector>

namespace tedavis::host_sim {

using GdalDataset = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

/// Opens a raster: a file, the first raster inside a zip archive, the only height grid of a netCDF file, or the grid of a name
/// such as NETCDF:"file.nc":z. Throws UserError, one sentence, where there is none.
[[nodiscard]] GdalDataset open_raster_file(const std::string& file);

/// The raster's own file and all that GDAL reads with it: world files, projections, masks, statistics, overviews, and the parts
/// of a virtual raster with their masks, statistics and overviews, also through virtual rasters among them. For a file that is no
/// raster, its own name alone. Sorted by name, without duplicates; files that GDAL names need not exist.
[[nodiscard]] std::vector<std::string> files_of_raster(const std::string& file);

}  // namespace tedavis::host_sim
