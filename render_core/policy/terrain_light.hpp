/// The directions of a style's lights in a frame: fixed, or the first one as the sun.
///
/// The sun's position needs a date: the instant that the design names, else the flight's time where it is a date. Without a
/// date, and while the sun is too low, the design's fixed light is used and the record states why: terrain must stay readable
/// at night. Pure functions; any thread.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/time.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::policy {

enum class LightSource : std::uint8_t {
    fixed,        ///< by the design
    sun,          ///< of date, time and place
    no_date,      ///< the sun was requested, but the flight's time is not a date
    sun_too_low,  ///< the sun was requested, but it is night, or so low that nearly all ground is in shade
};

/// Below this elevation the fixed light replaces the sun.
inline constexpr double kLowestSun_rad = base::radians(3);

struct TerrainLight {
    LightSource source = LightSource::fixed;
    double azimuth_rad = 0, elevation_rad = 0;  ///< direction of the first light; azimuth 0..2 pi, clockwise from true north
};

[[nodiscard]] TerrainLight terrain_light(const design::ShadeSettings& shade, const earth::Geodetic& place,
                                         base::Time flight_time) noexcept;

/// Returns the unit vector (ECEF) from `place` towards a light.
[[nodiscard]] glm::dvec3 towards_light(double azimuth_rad, double elevation_rad, const earth::Geodetic& place) noexcept;

}  // namespace tedavis::policy
