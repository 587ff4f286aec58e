/// `tedavis shot`: one picture from a given pose, and its FrameRecord.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct ShotOptions {
    AircraftPose pose;
    std::optional<base::Time> time;  ///< time of the data's age; nothing: data are shown at their own time
    std::string phase;               ///< "takeoff.first_climb", as if a switch stated it; empty: none is stated
    PictureOptions picture;
    AccuracyShown accuracy;
    bool strict = false;  ///< the command returns kCheckFailedExitCode where there are findings
    bool layers = false;  ///< also writes X.layers.png, the layer of each pixel
    std::string output;   ///< X.png or X; the record is written beside it as X.json
};

/// Returns the exit code, 2 also for a picture whose terrain failed, 1 where it is strict and there are findings; throws
/// UserError.
[[nodiscard]] int run_shot(const ShotOptions& options, Console& console);

}  // namespace tedavis::host_sim
