/// A script and the scripts that it includes, as trees of values in which the parameters are replaced.
#pragma once

#include <string>
#include <vector>

#include "host_sim/flight_test/script_value.hpp"

namespace tedavis::host_sim {

struct IncludedScripts {
    std::vector<ScriptValue> files;  ///< the included ones before those that include them; each once
    std::vector<std::string> paths;
    std::vector<std::string> parameters;  ///< names
    bool is_broken = false;               ///< a file is no TOML, so that its content is not known
};

/// A parameter of an including file overrides one of the same name in an included file; `stated` overrides all. Cycles, files
/// that cannot be read and parameters of `path` that no file uses are faults. Throws UserError where `path` itself cannot be
/// read.
[[nodiscard]] IncludedScripts read_included_scripts(const std::string& path, const ScriptParameters& stated,
                                                    ScriptFaults& faults);

}  // namespace tedavis::host_sim
