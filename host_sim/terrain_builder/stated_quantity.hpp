/// What a raster says it holds where that is no height: radar, temperature, a quality.
#pragma once

#include <gdal_priv.h>

#include <optional>
#include <string>

namespace tedavis::host_sim {

/// "'DBZH' (dataset1_data1_what_quantity)" of the first statement in the metadata of the dataset and of its first band that names
/// another quantity or unit; nothing where all that is stated may be a height, or nothing is.
///
/// ODIM_H5 (weather radar): `quantity`. CF conventions: `standard_name` and `units`.
[[nodiscard]] std::optional<std::string> other_quantity(GDALDataset& dataset);

}  // namespace tedavis::host_sim
