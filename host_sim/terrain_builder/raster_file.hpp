/// Height files as GDAL opens them: alone, inside a zip archive, or one of several grids in a file.
#pragma once

#include <gdal_priv.h>

#include <memory>
#include <string>

namespace tedavis::host_sim {

using GdalDataset = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

/// Opens a raster: a file, the first raster inside a zip archive, the only height grid of a netCDF file, or the grid that a
/// name such as NETCDF:"file.nc":z means. Throws UserError, one sentence, for what is none.
[[nodiscard]] GdalDataset open_raster_file(const std::string& file);

}  // namespace tedavis::host_sim
