/// The result of `check` for a valid file.
#pragma once

#include <string>

#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

struct CheckedFile {
    std::string is;  ///< "a candump log of 312 frames"
    Findings warnings;

    CheckedFile(std::string kind, Findings found = {})  // most files are sound or not. NOLINT(*-explicit-*)
        : is(std::move(kind)), warnings(std::move(found)) {}
};

}  // namespace tedavis::host_sim
