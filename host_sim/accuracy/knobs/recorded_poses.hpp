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
    double step_s = 0;           ///< between two sampled times
    /// The poses at the sampled times at which the position is valid and within the borders of the terrain, ascending; at least
    /// one. Times count from the log's first frame, so they are no dates, and data are shown at their own first time, as by
    /// `shot`.
    std::vector<AircraftPose> valid;
};

/// Plays the log over a terrain database (.tdb) and samples the display's own ship and phase ten times a second, but at most
/// 36,000 times in a long flight. Throws UserError for what FlightPlayer refuses and for a log without a valid position over the
/// terrain; Interrupted.
[[nodiscard]] RecordedPoses read_recorded_poses(const PlayerFiles& files, const std::string& terrain, Console& console);

}  // namespace tedavis::host_sim
