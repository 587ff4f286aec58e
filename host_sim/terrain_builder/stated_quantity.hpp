/// Detects rasters whose metadata state another quantity than height, such as radar, temperature or a quality.
#pragma once

#include <gdal_priv.h>

#include <optional>
#include <string>

namespace tedavis::host_sim {

/// Returns the first statement in the metadata of the dataset and of its first band that names another quantity or unit, such as
/// "'DBZH' (dataset1_data1_what_quantity)"; nothing where there is none.
///
/// ODIM_H5 (weather radar): `quantity`. CF conventions: `standard_name` and `units`.
[[nodiscard]] std::optional<std::string> other_quantity(GDALDataset& dataset);

}  // namespace tedavis::host_sim
