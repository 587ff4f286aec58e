/// Viewpoints round a place, each looking at it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::host_sim {

/// The viewpoints of a sweep: every distance with every height in every bearing.
struct SweepRings {
    static constexpr std::size_t kMaxBearings = 72, kMaxSteps = 16;
    static constexpr double kMinDistance_m = 10, kMaxDistance_m = 100'000, kMaxHeight_m = 30'000;
    std::size_t bearings = 8;  ///< evenly round the place, from north over east
    std::vector<double> distances_m{3000, 6000};
    std::vector<double> heights_m{300, 1000};  ///< above the place
};

struct Viewpoint {
    double bearing_deg = 0;  ///< from the place to it
    double distance_m = 0;   ///< over the ellipsoid, with a relative error of at most 1e-4
    double height_m = 0;
    earth::Geodetic position;
    AircraftPose pose;  ///< wings level, the nose pointing at the place
    std::string name;   ///< name of its files, "h1500_d3000_b045"
};

using GeoidBelowPlace = std::function<earth::GeoidUndulation(double latitude_rad, double longitude_rad)>;

/// Returns the viewpoints ordered by height, then distance, then bearing. Heights are differences of altitudes above mean sea
/// level.
[[nodiscard]] std::vector<Viewpoint> viewpoints_round(const earth::Geodetic& place, const GeoidBelowPlace& geoid,
                                                      const SweepRings& rings);

}  // namespace tedavis::host_sim
