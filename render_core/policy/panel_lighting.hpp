/// The brightness of the display: as the design states, or by the sun's elevation. Pure; any thread.
///
/// By the sun: day at 6 degrees above the horizon and more, dusk at the horizon, night at 6 degrees below (the end of civil
/// twilight) and less, with continuous transitions.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/time.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::policy {

struct PanelLight {
    glm::dvec3 white{1, 1, 1};  ///< factor of every colour, 0..1
    bool has_date = true;       ///< false: the sun's elevation is needed but the flight's time is not a date; day is used
};

[[nodiscard]] PanelLight panel_light(const design::ViewEffects& effects, const earth::Geodetic& place,
                                     base::Time flight_time) noexcept;

}  // namespace tedavis::policy
