/// Whether a scene can have anything to do with a flight.
#pragma once

#include <string>

#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// `scene`: path of a scene database, or empty; `flown`: where the own ship was. Throws UserError where the database cannot be
/// read.
[[nodiscard]] Findings scene_findings(const std::string& scene, const GeoExtent& flown);

}  // namespace tedavis::host_sim
