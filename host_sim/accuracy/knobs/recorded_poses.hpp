/// The poses of a recorded flight, from its CAN log, as `tedavis replay` reads it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct RecordedPoses {
    std::string log;             ///< as the user named it
    std::uint64_t identity = 0;  ///< of the bytes of the log and of the switch log
    double step_s = 0;           ///< between two instants that were asked for
    /// At the instants at which the position is valid and within the borders of the terrain, in order of time; at least one.
    /// Their times count from the log's first frame, so they are no date, and data are shown at their own first time, as `shot`
    /// shows them.
    std::vector<AircraftPose> valid;
};

/// Plays the log over a terrain database (.tdb), and takes what a display states of its own ship and its phase ten times a
/// second, of a longer flight less often: at most 36,000 times. Throws UserError: what FlightPlayer refuses, or a log without a
/// valid position over the terrain; Interrupted.
[[nodiscard]] RecordedPoses read_recorded_poses(const PlayerFiles& files, const std::string& terrain, Console& console);

}  // namespace tedavis::host_sim
