/// The WGS84 ellipsoid: geodetic <-> Earth-centred Earth-fixed (ECEF) coordinates, and local frames.
///
/// Units metres and radians. Pure functions of double; no tables. ECEF axes: x through (0N, 0E), z through the north pole.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::earth {

inline constexpr double kSemiMajorAxis_m = 6378137.0;
inline constexpr double kFlattening = 1.0 / 298.257223563;
inline constexpr double kEccentricitySquared = kFlattening * (2.0 - kFlattening);

/// (2 a + b) / 3
inline constexpr double kMeanRadius_m = 6'371'008.8;

/// Below every radius of curvature at heights from 439 m below the ellipsoid up: over a distance d the vertical turns by d over
/// this at most.
inline constexpr double kMinCurvatureRadius_m = 6335000;
/// Above every one of the ellipsoid itself.
inline constexpr double kGreatestCurvatureRadius_m = 6400000;

using Ecef = glm::dvec3;

[[nodiscard]] Ecef to_ecef(const Geodetic& position) noexcept;

/// Fukushima, "Transformation from Cartesian to geodetic coordinates accelerated by Halley's method", J. Geodesy 79
/// (2006), with two iterations. Checked in tests against GeographicLib: below 1 um for -10 km .. +100 km everywhere
/// (and down to 1000 km from the centre). On the axis (x and y zero) longitude is 0. Closer than 1000 km to the Earth's centre
/// the answer is defined but not geodetic: geocentric latitude, and height = distance from the centre - semi-major axis.
[[nodiscard]] Geodetic from_ecef(const Ecef& position) noexcept;

/// Columns north, east, down as ECEF unit vectors at a place. At a pole the given longitude chooses north.
[[nodiscard]] glm::dmat3 north_east_down(double latitude_rad, double longitude_rad) noexcept;

/// Unit vector up at a place: the gradient of the ellipsoid through it of the same shape. Off from the vertical by less than
/// 1e-5 rad within 10 km of the ellipsoid. The Earth's centre has none.
[[nodiscard]] glm::dvec3 up_at(const Ecef& place) noexcept;

/// Attitude of the aircraft in ECEF: columns forward, right, down of the body. Heading from true north, clockwise
/// positive; pitch nose up positive; roll right wing down positive (ISO 1151 order yaw, pitch, roll).
[[nodiscard]] glm::dmat3 body_axes(double latitude_rad, double longitude_rad, double heading_rad, double pitch_rad,
                                   double roll_rad) noexcept;

/// Radii of curvature at a latitude, metres.
[[nodiscard]] double meridian_radius_m(double latitude_rad) noexcept;
[[nodiscard]] double prime_vertical_radius_m(double latitude_rad) noexcept;

/// Distance along the surface from the chord through the Earth: s = 2R asin(c / 2R). Heights are ignored. Error below
/// 1e-6 of the distance, or 10 nm where that is more, up to 400 km (tested against GeographicLib's geodesic); not for more.
[[nodiscard]] double surface_distance_m(const Geodetic& a, const Geodetic& b) noexcept;

}  // namespace tedavis::earth
