/// A generated flight trail of a posed aircraft, so that single pictures can show the own flight. It is straight or a steady
/// turn, with constant wind and temperature, and an accuracy that changes linearly.
#pragma once

#include <vector>

namespace tedavis::host_sim {

struct AircraftPose;

struct FlownHistory {
    double seconds = 0;  ///< duration of the flight before the pose; 0: none
    double speed_mps = 60;
    double turn_deg_per_s = 0;
    double climb_mps = 0;
    double wind_mps = 0, wind_from_deg = 0;
    double temperature_c = 0;
    double accuracy_m = 10;         ///< accuracy of position and height at the pose, 95 %
    double accuracy_before_m = 10;  ///< the same at the beginning; it changes linearly
};

inline constexpr double kHistoryStep_s = 2;

/// Returns the poses before `pose`, the earliest first, every kHistoryStep_s. Each has its own time and accuracy.
[[nodiscard]] std::vector<AircraftPose> poses_before(const AircraftPose& pose);

}  // namespace tedavis::host_sim
