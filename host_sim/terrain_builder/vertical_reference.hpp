/// The vertical datum and unit that a file states for its heights.
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>
#include <string>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

struct VerticalReference {
    std::optional<VerticalDatum> datum;  ///< empty where nothing is stated
    std::string name;                    ///< name in the file
    bool is_depth = false;               ///< positive downwards
    std::string unit;                    ///< of the heights; empty where nothing is stated
};

/// Returns the vertical part of a coordinate system: compound systems have one, three-dimensional ones are ellipsoidal.
[[nodiscard]] VerticalReference vertical_reference(const OGRSpatialReference& crs);

/// Returns the statements of netCDF variables (CF conventions), USGS DEM headers and ESRI projection files that are not in the
/// coordinate system.
[[nodiscard]] VerticalReference vertical_reference_of_band(GDALDataset& dataset);

/// True for a sea-level datum that may differ from EGM96 by more than the heights' noise.
[[nodiscard]] bool is_other_sea_level(const VerticalReference& reference);

/// Returns the system without its vertical part, since transformations of places must not change heights.
[[nodiscard]] OGRSpatialReference horizontal_part(const OGRSpatialReference& crs);

/// Length of a unit in metres by its name ("", "m", "ft", "US survey foot", ...); nothing for what is no length.
[[nodiscard]] std::optional<double> metres_per_unit(const std::string& name);

}  // namespace tedavis::host_sim
