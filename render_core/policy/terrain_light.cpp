#include "render_core/policy/terrain_light.hpp"

#include <cmath>

#include "render_core/base/utc_time.hpp"
#include "render_core/earth/sun_position.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::policy {
TerrainLight terrain_light(const design::ShadeSettings& shade, const earth::Geodetic& place, base::Time flight_time) noexcept {
    TerrainLight light;
    light.azimuth_rad = shade.lights[0].azimuth_rad;
    light.elevation_rad = shade.lights[0].elevation_rad;
    if (!shade.follows_sun) return light;
    const base::Time utc = shade.sun_is_fixed ? shade.sun_utc : flight_time;
    if (!base::can_be_utc(utc)) {
        light.source = LightSource::no_date;
        return light;
    }
    const double utc_s = base::seconds_since_1970(utc);
    const earth::SunPosition sun = earth::sun_position(utc_s, place.latitude_rad, place.longitude_rad);
    light.source = sun.elevation_rad < kLowestSun_rad ? LightSource::sun_too_low : LightSource::sun;
    if (light.source == LightSource::sun_too_low) return light;
    light.azimuth_rad = sun.azimuth_rad;
    light.elevation_rad = sun.elevation_rad;
    return light;
}

glm::dvec3 towards_light(double azimuth_rad, double elevation_rad, const earth::Geodetic& place) noexcept {
    const double c = std::cos(elevation_rad);
    return earth::north_east_down(place.latitude_rad, place.longitude_rad) *
           glm::dvec3(c * std::cos(azimuth_rad), c * std::sin(azimuth_rad), -std::sin(elevation_rad));
}

}  // namespace tedavis::policy
