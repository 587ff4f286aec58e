/// `tedavis verify SCRIPT.toml… [--set name=value] [--junit F.xml] [-o DIR]`: flies flight tests on the desk.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct VerifyOptions {
    std::vector<std::string> scripts;     ///< files, shipped names, and folders, which stand for the scripts directly in them
    std::vector<std::string> parameters;  ///< "name=value"
    std::string junit;                    ///< file; empty: none
    std::string output;                   ///< folder for pictures and records of failures; empty: none are written
};

/// Returns 0 where all expectations hold, kCheckFailedExitCode where one does not, and kFaultyInputExitCode, with a sentence for
/// each fault, before anything is flown where a script is faulty. Throws UserError and Interrupted.
[[nodiscard]] int run_verify(const VerifyOptions& options, Console& console);

/// Scripts of a folder, in the order of their names; those of its folders, which are there to be included, are left out.
[[nodiscard]] std::vector<std::string> scripts_of_folder(const std::string& folder);

}  // namespace tedavis::host_sim
