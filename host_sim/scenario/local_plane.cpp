#include "host_sim/scenario/local_plane.hpp"

#include <cmath>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {

LocalPlane::LocalPlane(double latitude_rad, double longitude_rad)
    : latitude_rad_(latitude_rad),
      longitude_rad_(longitude_rad),
      longitude_per_m_(1 / (earth::prime_vertical_radius_m(latitude_rad) * std::cos(latitude_rad))),
      latitude_per_m_(1 / earth::meridian_radius_m(latitude_rad)) {}

PlanePlace LocalPlane::at(double east_m, double north_m) const {
    return {latitude_rad_ + north_m * latitude_per_m_, earth::wrap_longitude(longitude_rad_ + east_m * longitude_per_m_)};
}

}  // namespace tedavis::host_sim
