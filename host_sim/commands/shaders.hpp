/// `tedavis shaders`: the linked programs of a design as binaries, for a device that has no compiler.
#pragma once

#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

struct ShadersOptions {
    std::string output;  ///< folder for one file per program (platform/programs/program_folder.hpp) and programs.json
    /// Without terrain, the shipped terrain and the data of the shipped scenario are built first, because the programs depend on
    /// the design and on the presence of terrain and data.
    PictureOptions picture;
};

/// Writes the programs; files of other designs and drivers are kept. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_shaders(const ShadersOptions& options, Console& console);

}  // namespace tedavis::host_sim
