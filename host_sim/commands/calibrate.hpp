/// `tedavis calibrate`: measures the cost of every effect on this machine and writes a file for --costs.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct CalibrateOptions {
    std::string output;  ///< the costs (.toml); a .json file beside it also has the measurements
    /// Without terrain, the shipped terrain and the data of the shipped scenario are built first. The design's own effects are
    /// measured in it, the others in shipped designs that request them.
    PictureOptions picture;
    std::optional<AircraftPose> pose;  ///< required with terrain; nothing: a view of the shipped terrain
    std::optional<base::Time> time;
    std::uint32_t rounds = 15;  ///< pairs of frames with and without each effect
};

/// Writes both files or none. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_calibrate(const CalibrateOptions& options, Console& console);

}  // namespace tedavis::host_sim
