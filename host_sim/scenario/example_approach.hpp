/// The state of an aircraft on a final approach over the shipped terrain in which every value of the display is stated: for
/// pictures that explain the display. The values are made up.
#pragma once

#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

[[nodiscard]] AircraftPose example_approach_pose();
/// The display must have terrain below the pose.
[[nodiscard]] flight::FrameInput example_approach(display::Display& display);

}  // namespace tedavis::host_sim
