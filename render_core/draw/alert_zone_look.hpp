/// The ground that comes too close to the predicted track (policy/terrain_alert_zone.hpp), as drawers color it.
///
/// Frame  places in ECEF, m, become metres on the plane that touches the Earth at the own ship. Plain data; pure; any thread.
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
    glm::dvec3 from{0}, north{0}, east{0};  ///< the own ship, and unit vectors
    glm::dvec3 forward{0}, right{0};        ///< along the track and across it; north and east without a speed
    glm::dvec2 runway_m{0};                 ///< ahead of the own ship, and to its right

    [[nodiscard]] bool is_shown() const { return colors.is_shown; }
    /// False where no ground up to a height above MSL is colored.
    [[nodiscard]] bool may_reach(double highest_msl_m) const;
    /// `none` while there is no alert.
    [[nodiscard]] policy::TerrainAhead at(const glm::dvec3& place, double height_msl_m) const;
};
static_assert(std::is_trivially_copyable_v<AlertZoneLook>);

[[nodiscard]] AlertZoneLook alert_zone_look(const policy::TerrainAlertZone& zone);

}  // namespace tedavis::draw
