/// From where the lights of a style shine in a frame: fixed, or the first one as the sun.
///
/// The sun of a date needs a date: the instant that the design names, else the flight's time where that is one. Without
/// one, and while the sun stands too low, the design's fixed light serves and the frame says why: terrain must stay readable at
/// night. Pure functions; any thread.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/time.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::policy {

enum class LightSource : std::uint8_t {
    fixed,        ///< by the design
    sun,          ///< of date, time and place
    no_date,      ///< the sun was asked for, but the flight's time is no date
    sun_too_low,  ///< the sun was asked for, but it is night, or it grazes the ground so that nearly all lies in the shade
};

/// Below, the fixed light takes the sun's place.
inline constexpr double kLowestSun_rad = base::radians(3);

struct TerrainLight {
    LightSource source = LightSource::fixed;
    double azimuth_rad = 0, elevation_rad = 0;  ///< of the first light as it shines; azimuth 0..2 pi, clockwise from true north
};

[[nodiscard]] TerrainLight terrain_light(const design::ShadeSettings& shade, const earth::Geodetic& place,
                                         base::Time flight_time) noexcept;

/// Unit vector, ECEF, from `place` to where a light shines from.
[[nodiscard]] glm::dvec3 towards_light(double azimuth_rad, double elevation_rad, const earth::Geodetic& place) noexcept;

}  // namespace tedavis::policy
