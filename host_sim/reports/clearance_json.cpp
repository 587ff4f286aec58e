#include "host_sim/reports/clearance_json.hpp"

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using ClearanceJson = nlohmann::ordered_json;

ClearanceJson number_or_null(const std::optional<double>& value) { return value ? ClearanceJson(*value) : ClearanceJson(); }

ClearanceJson ground_or_null(const std::optional<GroundPlace>& ground) {
    return ground ? ground_place_json(*ground) : ClearanceJson();
}

}  // namespace

nlohmann::ordered_json ground_place_json(const GroundPlace& ground) {
    return {{"distance_m", ground.distance_m},
            {"bearing_deg", base::degrees(ground.bearing_rad)},
            {"elevation_deg", base::degrees(ground.elevation_rad)},
            {"lat_deg", base::degrees(ground.place.latitude_rad)},
            {"lon_deg", base::degrees(ground.place.longitude_rad)},
            {"height_msl_m", ground.height_msl_m}};
}

nlohmann::ordered_json uncertainty_json(const ClearanceUncertainty& uncertainty) {
    return {{"height_above_terrain_m", number_or_null(uncertainty.height_above_terrain_m())},
            {"height_m", number_or_null(uncertainty.height_m)},
            {"terrain_m", number_or_null(uncertainty.terrain_m)},
            {"position_m", number_or_null(uncertainty.position_m)}};
}

nlohmann::ordered_json clearance_json(const std::optional<Clearance>& clearance) {
    if (!clearance) return {};
    ClearanceJson nearest = ground_place_json(clearance->nearest);
    nearest["off_track_deg"] = base::degrees(clearance->nearest_off_track_rad);
    nearest["complete"] = clearance->nearest_is_whole;
    const LevelClearance& level = clearance->level;
    return {{"uncertainty", uncertainty_json(clearance->uncertainty)},
            {"nearest", nearest},
            {"at_own_height",
             {{"within_m", ClearanceMeter::kLevelReach_m},
              {"ahead", ground_or_null(level.ahead)},
              {"left", ground_or_null(level.left)},
              {"right", ground_or_null(level.right)},
              {"complete", level.is_whole}}}};
}

}  // namespace tedavis::host_sim
