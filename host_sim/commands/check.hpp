/// `tedavis check FILE...`: validates any file that the programs read, or prints a design with what it inherits.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct CheckOptions {
    std::vector<std::string> files;
    std::string bus = "canaerospace";  ///< by which logs are read
    std::string switch_config;         ///< of switch logs; empty: the shipped panel that knows most of a log's lines
    bool strict = false;               ///< findings end it with kCheckFailedExitCode
    bool resolved = false;  ///< of one design, named as `--design` does, all that it says and inherits, in place of a verdict
};

/// 2 where a file is not sound, with one sentence for each fault on stderr; else 1 where it is strict and there are findings,
/// else 0. All files are looked at.
[[nodiscard]] int run_check(const CheckOptions& options, Console& console);

}  // namespace tedavis::host_sim
