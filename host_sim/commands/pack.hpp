/// `tedavis pack CONFIG -o DIR`: one folder with all that a configuration names, from which desk and board start.
#pragma once

#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct PackOptions {
    std::string config;  ///< configuration file, or a pack
    std::string output;  ///< folder
    bool replaces = false;
    std::string valid_from, valid_until;  ///< "2026-12-28"; empty: not stated
    std::string sign;                     ///< secret key of minisign; empty: none
};

/// Returns the exit code; throws UserError.
[[nodiscard]] int run_pack(const PackOptions& options, Console& console);

}  // namespace tedavis::host_sim
