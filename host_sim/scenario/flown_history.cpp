#include "host_sim/scenario/flown_history.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

/// One step back along the middle of the step's turn.
AircraftPose pose_before(AircraftPose pose) {
    const FlownHistory& flown = pose.flown;
    const double turn_deg = flown.turn_deg_per_s * kHistoryStep_s;
    const double course = base::radians(pose.heading_deg - 0.5 * turn_deg), gone_m = flown.speed_mps * kHistoryStep_s;
    const double latitude = base::radians(pose.latitude_deg);
    pose.latitude_deg -= base::degrees(gone_m * std::cos(course) / earth::meridian_radius_m(latitude));
    pose.longitude_deg -=
        base::degrees(gone_m * std::sin(course) / (earth::prime_vertical_radius_m(latitude) * std::cos(latitude)));
    pose.altitude_msl_m -= flown.climb_mps * kHistoryStep_s;
    pose.heading_deg -= turn_deg;
    pose.time.ns -= static_cast<std::int64_t>(kHistoryStep_s * 1e9);
    return pose;
}

}  // namespace

std::vector<AircraftPose> poses_before(const AircraftPose& pose) {
    std::vector<AircraftPose> poses;
    const double steps = std::floor(pose.flown.seconds / kHistoryStep_s);
    AircraftPose at = pose;
    for (double n = 1; n <= steps; ++n) {
        at = pose_before(at);
        at.flown.accuracy_m = pose.flown.accuracy_m + (pose.flown.accuracy_before_m - pose.flown.accuracy_m) * n / steps;
        poses.push_back(at);
    }
    std::reverse(poses.begin(), poses.end());
    return poses;
}

}  // namespace tedavis::host_sim
