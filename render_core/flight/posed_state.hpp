/// The state of an aircraft whose pose is stated instead of flown: of single pictures, and of frames that are drawn to be timed.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

/// Longitude and heading may lie beyond their ranges by whole turns.
struct StatedPose {
    double latitude_rad = 0, longitude_rad = 0, altitude_msl_m = 0;
    double heading_rad = 0, pitch_rad = 0, roll_rad = 0;  ///< the heading is true
};

/// Returns the state with position, altitude and attitude, all fresh at `time`. `undulation` is that of the place.
[[nodiscard]] AircraftState posed_state(const StatedPose& pose, earth::GeoidUndulation undulation, base::Time time) noexcept;

}  // namespace tedavis::flight
