/// What a file says about its heights: above what, and in which unit.
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>
#include <string>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

struct VerticalReference {
    std::optional<VerticalDatum> datum;  ///< empty where nothing is stated
    std::string name;                    ///< as the file calls it
    bool is_depth = false;               ///< positive downwards
    std::string unit;                    ///< of the heights; empty where nothing is stated
};

/// The vertical part of a coordinate system: compound ones have one, those of three dimensions are ellipsoidal.
[[nodiscard]] VerticalReference vertical_reference(const OGRSpatialReference& crs);

/// What netCDF variables (CF conventions), USGS DEM headers and ESRI projection files say beside the coordinate system.
[[nodiscard]] VerticalReference vertical_reference_of_band(GDALDataset& dataset);

/// True of a datum that the sea defines and that may differ from EGM96 by more than the heights' noise.
[[nodiscard]] bool is_other_sea_level(const VerticalReference& reference);

/// Without the vertical part: transformations of places must not touch heights.
[[nodiscard]] OGRSpatialReference horizontal_part(const OGRSpatialReference& crs);

/// Length of a unit in metres by its name ("", "m", "ft", "US survey foot", ...); nothing for what is no length.
[[nodiscard]] std::optional<double> metres_per_unit(const std::string& name);

}  // namespace tedavis::host_sim
