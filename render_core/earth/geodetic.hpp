/// Positions on and above the Earth, with heights whose datum is part of their type.
#pragma once

#include <type_traits>

namespace tedavis::earth {

/// Height above the WGS84 ellipsoid, as GNSS measures it. There is no implicit conversion to or from another datum.
struct EllipsoidHeight {
    double m = 0;
};

/// Height above mean sea level, EGM96, as terrain data and charts state it.
struct MslHeight {
    double m = 0;
};

/// Height N of the geoid above the ellipsoid; h = H + N.
struct GeoidUndulation {
    double m = 0;
};

[[nodiscard]] constexpr EllipsoidHeight to_ellipsoid(MslHeight height, GeoidUndulation undulation) {
    return {height.m + undulation.m};
}
[[nodiscard]] constexpr MslHeight to_msl(EllipsoidHeight height, GeoidUndulation undulation) { return {height.m - undulation.m}; }

/// Geodetic latitude [-pi/2, pi/2], longitude [-pi, pi), WGS84.
struct Geodetic {
    double latitude_rad = 0;
    double longitude_rad = 0;
    EllipsoidHeight height;
};
static_assert(std::is_trivially_copyable_v<Geodetic>);

/// Returns the equivalent longitude in [-pi, pi); any finite input.
[[nodiscard]] double wrap_longitude(double longitude_rad) noexcept;
/// Returns the equivalent angle in [0, 2 pi), for headings; any finite input. Never returns 2 pi.
[[nodiscard]] double wrap_heading(double angle_rad) noexcept;
/// Returns a - b in the shorter direction, in [-pi, pi]; exact across the antimeridian and through north.
[[nodiscard]] double angle_difference(double a_rad, double b_rad) noexcept;

}  // namespace tedavis::earth
