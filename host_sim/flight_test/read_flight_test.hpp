/// Reads a flight test's file with those that it includes.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_value.hpp"

namespace tedavis::host_sim {

/// What a script has that does not say it: files or shipped names.
struct ScriptDefaults {
    std::string design = "default", device = "es2-small", bus = "canaerospace", switches = "one_hot";
    DesignFolders design_folders;  ///< of the names in `design`
};

/// `stated` are parameters of the command line: they come before those of the files. All faults are added to `faults`; with some,
/// the test must not be run. Throws UserError where the file itself cannot be read.
[[nodiscard]] FlightTest read_flight_test(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults,
                                          const ScriptDefaults& defaults = ScriptDefaults());

/// Names of the design of a picture, and of those of its phases. Throws UserError.
[[nodiscard]] std::vector<std::string> design_names(const PictureOptions& picture);

}  // namespace tedavis::host_sim
