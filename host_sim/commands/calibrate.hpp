/// `tedavis calibrate`: what everything costs on this machine, as a file for --costs.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct CalibrateOptions {
    std::string output;  ///< the costs (.toml); beside it the same with what it was measured from, as .json
    /// Without terrain, the shipped one and the data of the shipped scenario are built first. Its design's own effects are
    /// measured in it, the others in shipped designs that ask for them.
    PictureOptions picture;
    std::optional<AircraftPose> pose;  ///< needed with terrain; nothing: a view of the shipped one
    std::optional<base::Time> time;
    std::uint32_t rounds = 15;  ///< frames with and without each effect, in turn
};

/// Writes both files or none. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_calibrate(const CalibrateOptions& options, Console& console);

}  // namespace tedavis::host_sim
