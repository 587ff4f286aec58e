/// Whether a scene can have anything to do with a flight.
#pragma once

#include <string>

#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// Of the data of a scene database; empty without a path. Throws UserError where it cannot be read.
[[nodiscard]] GeoExtent extent_of_scene(const std::string& path);

/// `scene`: path of a scene database with this extent, or empty; `flown`: where the own ship was.
[[nodiscard]] Findings scene_findings(const std::string& scene, const GeoExtent& extent, const GeoExtent& flown);

}  // namespace tedavis::host_sim
