/// The WGS84 ellipsoid: conversion between geodetic and Earth-centred Earth-fixed (ECEF) coordinates, and local frames.
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

/// Lower bound of the radius of curvature at heights of -439 m and above: over a distance d the vertical turns by at most d
/// divided by this.
inline constexpr double kMinCurvatureRadius_m = 6335000;
/// Upper bound of the ellipsoid's radii of curvature.
inline constexpr double kGreatestCurvatureRadius_m = 6400000;

using Ecef = glm::dvec3;

[[nodiscard]] Ecef to_ecef(const Geodetic& position) noexcept;

/// Converts ECEF to geodetic coordinates after Fukushima, "Transformation from Cartesian to geodetic coordinates accelerated by
/// Halley's method", J. Geodesy 79 (2006), with two iterations. Error against GeographicLib, checked in tests: below 1 um for
/// heights of -10 km .. +100 km everywhere (and down to 1000 km from the centre). On the axis (x and y zero) longitude is 0.
/// Closer than 1000 km to the Earth's centre the answer is defined but not geodetic: geocentric latitude, and height = distance
/// from the centre - semi-major axis.
[[nodiscard]] Geodetic from_ecef(const Ecef& position) noexcept;

/// Returns the unit vectors north, east, down at a place, in ECEF, as columns. At a pole the longitude defines north.
[[nodiscard]] glm::dmat3 north_east_down(double latitude_rad, double longitude_rad) noexcept;

/// Returns the unit vector up at a place: the normal of the concentric, similar ellipsoid through it. It deviates from the
/// vertical by less than 1e-5 rad within 10 km of the ellipsoid. Undefined at the Earth's centre.
[[nodiscard]] glm::dvec3 up_at(const Ecef& place) noexcept;

/// Returns the aircraft's attitude in ECEF: the body's forward, right and down axes as columns. Heading from true north,
/// clockwise positive; pitch nose up positive; roll right wing down positive (ISO 1151 order yaw, pitch, roll).
[[nodiscard]] glm::dmat3 body_axes(double latitude_rad, double longitude_rad, double heading_rad, double pitch_rad,
                                   double roll_rad) noexcept;

/// Radii of curvature at a latitude, m.
[[nodiscard]] double meridian_radius_m(double latitude_rad) noexcept;
[[nodiscard]] double prime_vertical_radius_m(double latitude_rad) noexcept;

/// Returns the distance along the surface, m, from the chord c through the Earth: s = 2R asin(c / 2R). Heights are ignored.
/// Error below 1e-6 of the distance, or 10 nm where that is more, up to 400 km (tested against GeographicLib's geodesic); not
/// for more.
[[nodiscard]] double surface_distance_m(const Geodetic& a, const Geodetic& b) noexcept;

}  // namespace tedavis::earth
