#include "render_core/earth/wgs84.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::earth {

Ecef to_ecef(const Geodetic& position) noexcept {
    const double sin_lat = std::sin(position.latitude_rad);
    const double cos_lat = std::cos(position.latitude_rad);
    const double n = kSemiMajorAxis_m / std::sqrt(1.0 - kEccentricitySquared * sin_lat * sin_lat);
    const double rho = (n + position.height.m) * cos_lat;
    return {rho * std::cos(position.longitude_rad), rho * std::sin(position.longitude_rad),
            (n * (1.0 - kEccentricitySquared) + position.height.m) * sin_lat};
}

namespace {

/// Closer to the centre than this the nearest ellipsoid point need not be unique and the iteration need not converge.
constexpr double kCoreRadius_m = 1.0e6;

/// Inside the core: the geocentric direction, and the height below the equatorial sphere.
Geodetic from_core(const Ecef& position, double p, double r) {
    return {p + std::abs(position.z) > 0 ? std::atan2(position.z, p) : 0.0,
            p > 0 ? std::atan2(position.y, position.x) : 0.0,
            {r - kSemiMajorAxis_m}};
}

}  // namespace

glm::dvec3 up_at(const Ecef& place) noexcept {
    return glm::normalize(glm::dvec3(place.x, place.y, place.z / (1 - kEccentricitySquared)));
}

Geodetic from_ecef(const Ecef& position) noexcept {
    const double p = std::hypot(position.x, position.y);
    const double r = std::hypot(p, position.z);
    if (r < kCoreRadius_m) return from_core(position, p, r);
    const double a = kSemiMajorAxis_m;
    const double e2 = kEccentricitySquared;
    const double ec = std::sqrt(1.0 - e2);
    const double z = std::abs(position.z);
    if (p < 1e-9)
        return {std::copysign(0.5 * base::kPi, position.z), p > 0 ? std::atan2(position.y, position.x) : 0.0, {z - a * ec}};
    const double radial = p / a;
    const double axial = ec * (z / a);
    // s/c is the tangent of the reduced latitude, refined by Halley's method without a division.
    double s = z;
    double c = ec * p;
    for (int iteration = 0; iteration < 2; ++iteration) {
        const double g = std::hypot(s, c);
        const double sn = s / g;
        const double cn = c / g;
        const double d = axial + e2 * sn * sn * sn;
        const double f = radial - e2 * cn * cn * cn;
        const double b = 1.5 * e2 * sn * cn * cn * (radial * sn - axial * cn - e2 * sn * cn);
        s = d * f - b * sn;
        c = f * f - b * cn;
    }
    const double cc = ec * c;
    const double height = (p * cc + z * s - a * std::sqrt(ec * ec * s * s + cc * cc)) / std::hypot(cc, s);
    return {std::copysign(std::atan2(s, cc), position.z), std::atan2(position.y, position.x), {height}};
}

glm::dmat3 north_east_down(double latitude_rad, double longitude_rad) noexcept {
    const double sin_lat = std::sin(latitude_rad), cos_lat = std::cos(latitude_rad);
    const double sin_lon = std::sin(longitude_rad), cos_lon = std::cos(longitude_rad);
    return {glm::dvec3(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat), glm::dvec3(-sin_lon, cos_lon, 0.0),
            glm::dvec3(-cos_lat * cos_lon, -cos_lat * sin_lon, -sin_lat)};
}

glm::dmat3 body_axes(double latitude_rad, double longitude_rad, double heading_rad, double pitch_rad, double roll_rad) noexcept {
    const double ch = std::cos(heading_rad), sh = std::sin(heading_rad);
    const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
    const double cr = std::cos(roll_rad), sr = std::sin(roll_rad);
    const glm::dmat3 body_in_ned{glm::dvec3(ch * cp, sh * cp, -sp),
                                 glm::dvec3(ch * sp * sr - sh * cr, sh * sp * sr + ch * cr, cp * sr),
                                 glm::dvec3(ch * sp * cr + sh * sr, sh * sp * cr - ch * sr, cp * cr)};
    return north_east_down(latitude_rad, longitude_rad) * body_in_ned;
}

double meridian_radius_m(double latitude_rad) noexcept {
    const double sin_lat = std::sin(latitude_rad);
    const double w2 = 1.0 - kEccentricitySquared * sin_lat * sin_lat;
    return kSemiMajorAxis_m * (1.0 - kEccentricitySquared) / (w2 * std::sqrt(w2));
}

double prime_vertical_radius_m(double latitude_rad) noexcept {
    const double sin_lat = std::sin(latitude_rad);
    return kSemiMajorAxis_m / std::sqrt(1.0 - kEccentricitySquared * sin_lat * sin_lat);
}

double surface_distance_m(const Geodetic& a, const Geodetic& b) noexcept {
    const Ecef pa = to_ecef({a.latitude_rad, a.longitude_rad, {0}});
    const Ecef pb = to_ecef({b.latitude_rad, b.longitude_rad, {0}});
    const double chord = glm::length(pb - pa);
    // Radius of curvature along the chord's azimuth at the middle latitude (Euler).
    const double latitude = 0.5 * (a.latitude_rad + b.latitude_rad);
    const double north = b.latitude_rad - a.latitude_rad;
    const double east = angle_difference(b.longitude_rad, a.longitude_rad) * std::cos(latitude);
    const double along = north * north + east * east;
    const double m = meridian_radius_m(latitude);
    const double n = prime_vertical_radius_m(latitude);
    const double radius = along > 0 ? along * m * n / (north * north * n + east * east * m) : m;
    const double sine = chord / (2.0 * radius);
    return 2.0 * radius * std::asin(sine < 1.0 ? sine : 1.0);
}

}  // namespace tedavis::earth
