/// How bright the display is: as the design says, or by the sun of place and date. Pure; any thread.
///
/// By the sun: day from 6 degrees above the horizon, dusk at the horizon, night from 6 below (the end of civil twilight), and
/// steadily in between, so that nothing jumps.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/time.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::policy {

struct PanelLight {
    glm::dvec3 white{1, 1, 1};  ///< what every colour is multiplied with, 0..1
    bool has_date = true;       ///< false: by the sun, but the flight's time is no date; then it is day
};

[[nodiscard]] PanelLight panel_light(const design::ViewEffects& effects, const earth::Geodetic& place,
                                     base::Time flight_time) noexcept;

}  // namespace tedavis::policy
