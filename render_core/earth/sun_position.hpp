/// Position of the sun: Meeus, "Astronomical Algorithms", 2nd ed., chapters 12, 13, 22 and 25 (low accuracy, 0.01 degrees
/// between 1950 and 2100). It is that of the disc's centre, without refraction, seen from the Earth's centre (the parallax is
/// below 0.003 degrees). Pure function; any thread.
#pragma once

namespace tedavis::earth {

struct SunPosition {
    double azimuth_rad = 0;    ///< clockwise from true north, [0, 2 pi)
    double elevation_rad = 0;  ///< above the horizontal, negative at night
};

/// `utc_s` is in seconds since 1970-01-01T00:00:00 UTC without leap seconds. Latitude [-pi/2, pi/2]; any longitude.
[[nodiscard]] SunPosition sun_position(double utc_s, double latitude_rad, double longitude_rad) noexcept;

/// Apparent position of the sun on the celestial sphere at a Julian ephemeris day.
struct SunPlace {
    double right_ascension_rad = 0;  ///< [0, 2 pi)
    double declination_rad = 0;
};
[[nodiscard]] SunPlace sun_place(double julian_day) noexcept;

}  // namespace tedavis::earth
