#include "render_core/earth/sun_position.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::earth {
namespace {

using base::radians;

constexpr double kJ2000 = 2451545.0, kJulianDayOfUnixEpoch = 2440587.5, kDaysPerCentury = 36525.0, kSecondsPerDay = 86400.0;
constexpr double kTerrestrialMinusUtc_s =
    69.2;  // since 2017; a minute more or less moves the sun by less than a thousandth of a degree

double sine_deg(double angle_deg) { return std::sin(radians(std::remainder(angle_deg, 360.0))); }
double cosine_deg(double angle_deg) { return std::cos(radians(std::remainder(angle_deg, 360.0))); }

}  // namespace

SunPlace sun_place(double julian_day) noexcept {
    const double t = (julian_day - kJ2000) / kDaysPerCentury;
    const double mean_longitude_deg = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly_deg = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double centre_deg = (1.914602 - t * (0.004817 + t * 0.000014)) * sine_deg(anomaly_deg) +
                              (0.019993 - t * 0.000101) * sine_deg(2 * anomaly_deg) + 0.000289 * sine_deg(3 * anomaly_deg);
    const double node_deg = 125.04 - 1934.136 * t;
    const double longitude_deg = mean_longitude_deg + centre_deg - 0.00569 - 0.00478 * sine_deg(node_deg);
    const double obliquity_deg =
        23.439291111 - t * (0.013004167 + t * (0.000000164 - t * 0.000000504)) + 0.00256 * cosine_deg(node_deg);
    const double sine_of_longitude = sine_deg(longitude_deg);
    const double ascension_rad = std::atan2(cosine_deg(obliquity_deg) * sine_of_longitude, cosine_deg(longitude_deg));
    return {wrap_heading(ascension_rad), std::asin(sine_deg(obliquity_deg) * sine_of_longitude)};
}

SunPosition sun_position(double utc_s, double latitude_rad, double longitude_rad) noexcept {
    const double day = kJulianDayOfUnixEpoch + utc_s / kSecondsPerDay;
    const SunPlace sun = sun_place(day + kTerrestrialMinusUtc_s / kSecondsPerDay);
    const double t = (day - kJ2000) / kDaysPerCentury;
    const double sidereal_deg = 280.46061837 + 360.98564736629 * (day - kJ2000) + t * t * 0.000387933;
    const double hour_rad = radians(std::remainder(sidereal_deg, 360.0)) + longitude_rad - sun.right_ascension_rad;
    // East, north, up of the sun's direction.
    const double cos_d = std::cos(sun.declination_rad), sin_d = std::sin(sun.declination_rad);
    const double cos_l = std::cos(latitude_rad), sin_l = std::sin(latitude_rad);
    const double east = -cos_d * std::sin(hour_rad);
    const double north = cos_l * sin_d - sin_l * cos_d * std::cos(hour_rad);
    const double up = sin_l * sin_d + cos_l * cos_d * std::cos(hour_rad);
    return {wrap_heading(std::atan2(east, north)), std::atan2(up, std::hypot(east, north))};
}

}  // namespace tedavis::earth
