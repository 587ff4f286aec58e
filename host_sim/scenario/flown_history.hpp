/// A generated flight trail of a posed aircraft, so that single pictures can show the own flight. It is straight or a steady
/// turn, with constant wind, temperature and accuracy, except for the varied one.
#pragma once

#include <vector>

namespace tedavis::host_sim {

struct AircraftPose;

struct FlownHistory {
    double seconds = 0;  ///< up to the pose; 0: nothing was flown
    double speed_mps = 60;
    double turn_deg_per_s = 0;
    double climb_mps = 0;
    double wind_mps = 0, wind_from_deg = 0;
    double temperature_c = 0;
    double accuracy_m = 10;         ///< of the place at the pose, 95 %; of heights the same
    double accuracy_before_m = 10;  ///< and at the beginning, between which it changes evenly
};

inline constexpr double kHistoryStep_s = 2;

/// From the first one on, every kHistoryStep_s, without the pose itself. Each has the time and accuracy of its own.
[[nodiscard]] std::vector<AircraftPose> poses_before(const AircraftPose& pose);

}  // namespace tedavis::host_sim
