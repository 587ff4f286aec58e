/// `tedavis scene look`.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct SceneLookOptions {
    std::vector<std::string> files;
    std::string crs;  ///< of files that state none; empty: not given
};

/// Prints the content of each file and the lines with which a scene file can use it. Returns the exit code: kFaultyInputExitCode
/// if some of several files could not be read, each of which has a note. Throws UserError if none could.
[[nodiscard]] int run_scene_look(const SceneLookOptions& options, Console& console);

}  // namespace tedavis::host_sim
