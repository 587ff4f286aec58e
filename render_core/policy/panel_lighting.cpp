#include "render_core/policy/panel_lighting.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "render_core/base/units.hpp"
#include "render_core/base/utc_time.hpp"
#include "render_core/earth/sun_position.hpp"

namespace tedavis::policy {
namespace {

constexpr double kDay_rad = base::radians(6), kNight_rad = base::radians(-6);

glm::dvec3 factors(design::Color color) { return glm::dvec3(color.red, color.green, color.blue) / 255.0; }

glm::dvec3 white_by_sun(const design::ViewEffects& effects, double elevation_rad) {
    const glm::dvec3 day(1, 1, 1), dusk = factors(effects.dusk), night = factors(effects.night);
    if (elevation_rad >= 0) return glm::mix(dusk, day, std::min(elevation_rad / kDay_rad, 1.0));
    return glm::mix(dusk, night, std::min(elevation_rad / kNight_rad, 1.0));
}

}  // namespace

PanelLight panel_light(const design::ViewEffects& effects, const earth::Geodetic& place, base::Time flight_time) noexcept {
    switch (effects.lighting) {
        case design::PanelLighting::day: return {};
        case design::PanelLighting::dusk: return {factors(effects.dusk)};
        case design::PanelLighting::night: return {factors(effects.night)};
        case design::PanelLighting::automatic: break;
    }
    if (!base::can_be_utc(flight_time)) return {{1, 1, 1}, false};
    const double utc_s = base::seconds_since_1970(flight_time);
    return {white_by_sun(effects, earth::sun_position(utc_s, place.latitude_rad, place.longitude_rad).elevation_rad)};
}

}  // namespace tedavis::policy
