/// An aircraft with a fixed pose given by the user, for single pictures.
#pragma once

#include "host_sim/scenario/flown_history.hpp"
#include "render_core/display/display.hpp"
#include "render_core/flight/posed_state.hpp"

namespace tedavis::host_sim {

/// The time of single pictures without a stated time: not a date, so that data are shown at their own first time.
inline constexpr base::Time kPosedTime{0};

/// A pose in the user's units: degrees, and metres above mean sea level.
struct AircraftPose {
    double latitude_deg = 0, longitude_deg = 0, altitude_msl_m = 0;
    double heading_deg = 0, pitch_deg = 0, roll_deg = 0;
    base::Time time = kPosedTime;
    FlownHistory flown{};         ///< the flight before the pose
    flight::FlightPhase phase{};  ///< stated phase; unknown: none
};

/// Returns the pose in SI units, without time and history.
[[nodiscard]] flight::StatedPose stated_pose(const AircraftPose& pose);

/// Returns the state of the posed aircraft; all signals are fresh at the pose's time. With a history it also has wind,
/// temperature and accuracies. The geoid and the height above the ground come from the display's terrain; throws UserError where
/// it has none and the EGM96 grid is not installed.
[[nodiscard]] flight::AircraftState posed_aircraft(const AircraftPose& pose, display::Display& display);

}  // namespace tedavis::host_sim
