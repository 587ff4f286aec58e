/// `tedavis shaders`: the linked programs of a design as binaries, for a device that has no compiler.
#pragma once

#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

struct ShadersOptions {
    std::string output;  ///< folder of a file a program (platform/programs/program_folder.hpp) and programs.json
    /// Without terrain, the shipped one and the data of the shipped scenario are built first: which programs there are depends on
    /// the design, and on there being terrain and data at all.
    PictureOptions picture;
};

/// Files of programs that are not of this design and driver stay. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_shaders(const ShadersOptions& options, Console& console);

}  // namespace tedavis::host_sim
