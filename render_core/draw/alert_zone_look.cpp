#include "render_core/draw/alert_zone_look.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {

bool AlertZoneLook::may_reach(double highest_msl_m) const {
    return is_shown() && highest_msl_m > std::fmin(zone.floor_at(0), zone.floor_at(zone.until_s));
}

policy::TerrainAhead AlertZoneLook::at(const glm::dvec3& place, double height_msl_m) const {
    if (!is_shown()) return policy::TerrainAhead::none;
    const glm::dvec3 way = place - from;
    return policy::violation_at(zone, glm::dot(way, north), glm::dot(way, east), height_msl_m);
}

AlertZoneLook alert_zone_look(const policy::TerrainAlertZone& zone) {
    AlertZoneLook look;
    look.zone = zone;
    look.colors.is_shown = zone.alert != policy::TerrainAhead::none;
    if (!look.is_shown()) return look;
    const glm::dmat3 axes = earth::north_east_down(zone.from.latitude_rad, zone.from.longitude_rad);
    look.from = earth::to_ecef(zone.from);
    look.north = axes[0];
    look.east = axes[1];
    const double speed_mps = zone.speed_mps();
    const double north = speed_mps > 0 ? zone.north_mps / speed_mps : 1, east = speed_mps > 0 ? zone.east_mps / speed_mps : 0;
    look.forward = north * look.north + east * look.east;
    look.right = north * look.east - east * look.north;
    look.runway_m = {zone.runway.north_m * north + zone.runway.east_m * east,
                     zone.runway.east_m * north - zone.runway.north_m * east};
    return look;
}

}  // namespace tedavis::draw
