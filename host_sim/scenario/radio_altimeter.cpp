#include "host_sim/scenario/radio_altimeter.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/scenario/local_plane.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSlope_m = 150;  // from the strip's edge to the raster's ground

}  // namespace

RadioAltimeter::RadioAltimeter(const RadioAltimeterSettings& settings, const LandingStrip& strip)
    : range_m_(settings.range_m), strip_(strip), raster_(load_rasters({settings.terrain}, {})) {}

std::optional<double> RadioAltimeter::height_m(double latitude_rad, double longitude_rad, double wheels_msl_m) const {
    const double raster_share = std::clamp(off_strip_m(latitude_rad, longitude_rad) / kSlope_m, 0.0, 1.0);
    double ground_m = strip_.elevation_msl_m;
    if (raster_share > 0) {
        const std::optional<double> raster_m = raster_msl_m(latitude_rad, longitude_rad);
        if (!raster_m) return std::nullopt;
        ground_m += raster_share * (*raster_m - ground_m);
    }
    const double height_m = wheels_msl_m - ground_m;
    return height_m > range_m_ ? std::nullopt : std::optional<double>(height_m);
}

std::optional<double> RadioAltimeter::raster_msl_m(double latitude_rad, double longitude_rad) const {
    const double column = (base::degrees(longitude_rad) - raster_.west_deg) / raster_.step_lon_deg,
                 row = (raster_.north_deg - base::degrees(latitude_rad)) / raster_.step_lat_deg;
    if (!(column >= 0 && row >= 0 && column < raster_.columns - 1 && row < raster_.rows - 1)) return std::nullopt;
    const auto i = static_cast<std::uint32_t>(column), j = static_cast<std::uint32_t>(row);
    const double u = column - i, v = row - j;
    const auto post = [this](std::uint32_t x, std::uint32_t y) { return double{raster_.height_m[raster_.at(x, y)]}; };
    const double north = post(i, j) * (1 - u) + post(i + 1, j) * u, south = post(i, j + 1) * (1 - u) + post(i + 1, j + 1) * u;
    const double height_m = north * (1 - v) + south * v;
    return std::isfinite(height_m) ? std::optional<double>(height_m) : std::nullopt;
}

/// Distance from the nearest place of the strip; 0 on it.
double RadioAltimeter::off_strip_m(double latitude_rad, double longitude_rad) const {
    const LocalPlane plane(strip_.latitude_rad, strip_.longitude_rad);
    const double north_m = (latitude_rad - strip_.latitude_rad) / plane.latitude_per_m(),
                 east_m = earth::angle_difference(longitude_rad, strip_.longitude_rad) / plane.longitude_per_m();
    const double c = std::cos(strip_.heading_rad), s = std::sin(strip_.heading_rad);
    const double along_m = std::fabs(north_m * c + east_m * s), right_m = std::fabs(east_m * c - north_m * s);
    return std::hypot(std::max(0.0, along_m - strip_.length_m / 2), std::max(0.0, right_m - strip_.width_m / 2));
}

}  // namespace tedavis::host_sim
