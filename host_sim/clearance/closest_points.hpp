/// Finds where a flown track came closest to the terrain.
///
/// A closest point is a local minimum in time: both samples beside it are farther from the ground, or it is the first or last
/// sample of the flight. Take-off and landing are left out: samples that stand on the ground, and those less than kApart_s before
/// or after one. A sample beside one that is left out, or beside a gap, is no minimum. Chosen points are at least kApart_s apart.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/clearance/clearance.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

struct TrackSample {
    base::Time time;
    OwnShipPlace own;
    double height_above_terrain_m = 0;  ///< NaN: not known
    double along_m = 0;                 ///< distance flown over the ground since the first sample
    ClearanceUncertainty uncertainty;
    flight::FlightPhase phase;
    bool is_on_ground = false;
};

/// True in the phase ground; without a known phase, for an aircraft slower than 15 m/s less than 30 m above the ground.
[[nodiscard]] bool stands_on_ground(flight::FlightPhase phase, double ground_speed_mps, double height_above_terrain_m);

inline constexpr double kApart_s = 30;
inline constexpr double kLongestGap_s = 5;  ///< samples farther apart are not neighbours
inline constexpr std::size_t kMaxClosest = 5;

/// For each sample, whether it may be a closest point: its height is known, and it is not of take-off or landing.
[[nodiscard]] std::vector<bool> counted_samples(const std::vector<TrackSample>& track);

/// Returns the indices of up to kMaxClosest closest samples, the closest first. `value` is called for counted samples only; NaN:
/// not known.
[[nodiscard]] std::vector<std::size_t> closest_samples(const std::vector<TrackSample>& track,
                                                       const std::function<double(std::size_t)>& value);

/// The place between two samples, 0 <= share <= 1.
[[nodiscard]] TrackSample between(const TrackSample& a, const TrackSample& b, double share);

struct ClosestPoint {
    TrackSample sample;
    GroundPlace nearest;
};
struct ClosestPoints {
    std::vector<ClosestPoint> by_height, by_distance;
};

/// Searches the track, also between its samples.
[[nodiscard]] ClosestPoints closest_points(const std::vector<TrackSample>& track, ClearanceMeter& meter);

}  // namespace tedavis::host_sim
