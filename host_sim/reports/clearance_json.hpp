/// Clearances from the terrain as JSON, for records and summaries.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/clearance/clearance.hpp"

namespace tedavis::host_sim {

/// `clearance` of a frame's record, without the height above terrain, which `alerts.terrain` has; null where it is not known.
[[nodiscard]] nlohmann::ordered_json clearance_json(const std::optional<Clearance>& clearance);

/// `distance_m`, `bearing_deg`, `elevation_deg`, `lat_deg`, `lon_deg`, `height_msl_m`.
[[nodiscard]] nlohmann::ordered_json ground_place_json(const GroundPlace& ground);
/// `height_above_terrain_m`, `height_m`, `terrain_m`, `position_m`; null where it is not stated.
[[nodiscard]] nlohmann::ordered_json uncertainty_json(const ClearanceUncertainty& uncertainty);

}  // namespace tedavis::host_sim
