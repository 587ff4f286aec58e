#include "render_core/draw/drawers/alert_zone_uniforms.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

void set_row(float (&row)[4], double x, double y, double z, double w) {
    row[0] = static_cast<float>(x);
    row[1] = static_cast<float>(y);
    row[2] = static_cast<float>(z);
    row[3] = static_cast<float>(w);
}

void set_color_row(float (&row)[4], design::Color color, double strength) {
    set_row(row, color.red / 255.0, color.green / 255.0, color.blue / 255.0, strength);
}

}  // namespace

AlertZoneRows alert_zone_rows(const AlertZoneLook& look) {
    AlertZoneRows rows;
    const policy::TerrainAlertZone& zone = look.zone;
    const double speed_mps = zone.speed_mps(), turn_radps = std::fabs(zone.turn_radps);
    if (speed_mps > 0 && turn_radps >= policy::kMinTurn_radps)
        set_row(rows.of[0], speed_mps, speed_mps / turn_radps, zone.turn_radps > 0 ? 1 : -1, 1 / turn_radps);
    else
        set_row(rows.of[0], speed_mps, 0, 1, 0);
    set_row(rows.of[1], zone.radius_m, zone.radius_mps, zone.radius_mps2, look.is_shown() ? zone.until_s : -1);
    set_row(rows.of[2], zone.floor_msl_m, zone.floor_mps, policy::kTerrainWarning_s, 0);
    set_row(rows.of[3], look.runway_m.x, look.runway_m.y, zone.runway.radius_m, zone.runway.highest_msl_m);
    set_color_row(rows.of[4], look.colors.warning, look.colors.strength);
    set_color_row(rows.of[5], look.colors.caution, look.colors.strength);
    return rows;
}

void set_alert_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const AlertZoneLook& look,
                        const glm::dvec3& origin) {
    float axes[2][4];
    for (const bool is_right : {false, true}) {
        const glm::dvec3& axis = is_right ? look.right : look.forward;
        set_row(axes[is_right ? 1 : 0], axis.x, axis.y, axis.z, glm::dot(origin - look.from, axis));
    }
    const AlertZoneRows rows = alert_zone_rows(look);
    gl->Uniform4fv(program.uniform(first), 2, axes[0]);
    gl->Uniform4fv(program.uniform(first + 1), static_cast<GLsizei>(kAlertZoneRows), rows.of[0]);
}

}  // namespace tedavis::draw
