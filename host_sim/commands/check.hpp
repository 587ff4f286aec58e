/// `tedavis check FILE...`: validates any file that the programs read, or prints a design with what it inherits.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct CheckOptions {
    std::vector<std::string> files;
    std::string bus = "canaerospace";  ///< bus layout for logs
    std::string switch_config;         ///< for switch logs; empty: the shipped panel that knows most of a log's lines
    bool strict = false;               ///< findings give kCheckFailedExitCode
    bool resolved = false;  ///< prints one design, named as by `--design`, with all inherited keys, instead of a result
};

/// Returns 2 where a file is not valid, with one sentence for each fault on stderr; else 1 where it is strict and there are
/// findings, else 0. All files are checked.
[[nodiscard]] int run_check(const CheckOptions& options, Console& console);

}  // namespace tedavis::host_sim
