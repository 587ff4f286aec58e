/// The own ship's predicted track: at the current velocity, straight ahead or on a circle.
///
/// Frame     positions are geodetic, WGS84, heights above the ellipsoid in metres; velocities are in the local north, east, up
/// frame.
/// Range     about 100 km: metres are converted to angles with the radii of curvature at the first position. Plain data; pure.
#pragma once

#include <cmath>

#include "render_core/earth/geodetic.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::policy {

struct PredictedTrack {
    earth::Geodetic from;  ///< position of the own ship
    double north_mps = 0, east_mps = 0, up_mps = 0;
    double turn_radps = 0;  ///< of the direction over the ground, constant, to the right

    [[nodiscard]] double ground_speed_mps() const { return std::hypot(north_mps, east_mps); }
    [[nodiscard]] double metres_per_latitude_rad() const { return earth::meridian_radius_m(from.latitude_rad); }
    [[nodiscard]] double metres_per_longitude_rad() const {
        return earth::prime_vertical_radius_m(from.latitude_rad) * std::cos(from.latitude_rad);
    }
    /// Returns the position after `seconds`, `right_m` to the right of the track where it has a direction.
    [[nodiscard]] earth::Geodetic at(double seconds, double right_m = 0) const;
};

}  // namespace tedavis::policy
