/// Reads a flight test's file with those that it includes.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/script_value.hpp"

namespace tedavis::host_sim {

/// Values of keys that a script does not state: files or shipped names.
struct ScriptDefaults {
    std::string design = "default", device = "es2-small", bus = "canaerospace", switches = "one_hot";
    DesignFolders design_folders;  ///< of the names in `design`
};

/// `stated` are parameters of the command line, which override those of the files. All faults are added to `faults`; a test with
/// faults must not be run. Throws UserError where the file itself cannot be read.
[[nodiscard]] FlightTest read_flight_test(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults,
                                          const ScriptDefaults& defaults = ScriptDefaults());

/// Returns the names of a picture's design and of the designs of its phases. Throws UserError where one cannot be read.
[[nodiscard]] std::vector<std::string> design_names(const PictureOptions& picture);

}  // namespace tedavis::host_sim
