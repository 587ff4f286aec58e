/// How drawers colour the ground that comes too close to the predicted track (policy/terrain_alert_zone.hpp).
///
/// Frame  ECEF, m; places are projected to the plane that is tangent to the Earth at the own ship. Plain data; pure; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <type_traits>

#include "render_core/design/warning_bands.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"

namespace tedavis::draw {

struct AlertColors {
    bool is_shown = false;
    design::Color warning = design::kWarningGround, caution = design::kCautionGround;
    double strength = 0.65;  ///< 0..1, opacity over the ground's color: its relief stays visible
};

struct AlertZoneLook {
    policy::TerrainAlertZone zone;
    AlertColors colors;                     ///< shown while there is an alert
    glm::dvec3 from{0}, north{0}, east{0};  ///< the own ship's position; unit vectors; all ECEF
    glm::dvec3 forward{0}, right{0};        ///< unit vectors along and across the track, ECEF; without a speed north and east
    glm::dvec2 runway_m{0};                 ///< the runway's place nearest to the track: ahead of the own ship, and to its right

    [[nodiscard]] bool is_shown() const { return colors.is_shown; }
    /// False where no ground up to this height above MSL is coloured.
    [[nodiscard]] bool may_reach(double highest_msl_m) const;
    /// The alert level of ground at a place (ECEF, m) with this height; `none` while there is no alert.
    [[nodiscard]] policy::TerrainAhead at(const glm::dvec3& place, double height_msl_m) const;
};
static_assert(std::is_trivially_copyable_v<AlertZoneLook>);

[[nodiscard]] AlertZoneLook alert_zone_look(const policy::TerrainAlertZone& zone);

}  // namespace tedavis::draw
