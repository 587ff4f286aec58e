/// `tedavis shot`: one picture from a given pose, and its FrameRecord.
#pragma once

#include <string>

#include "host_sim/commands/replay.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// As the user writes it: degrees, metres above mean sea level.
struct ShotPose {
    double latitude_deg = 0, longitude_deg = 0, altitude_msl_m = 0;
    double heading_deg = 0, pitch_deg = 0, roll_deg = 0;
};

struct ShotOptions {
    ShotPose pose;
    std::string phase;  ///< "takeoff.first_climb", as if a switch stated it; empty: none is stated
    PictureOptions picture;
    std::string output;  ///< X.png; the record goes beside it as X.json; without an extension the same
};

/// Returns the exit code, 2 also for a picture whose terrain failed; throws UserError.
[[nodiscard]] int run_shot(const ShotOptions& options, Console& console);

}  // namespace tedavis::host_sim
