/// `tedavis check FILE...`: validates any file that the programs read.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct CheckOptions {
    std::vector<std::string> files;
};

/// 0 when every file is sound, else 2: one sentence for each fault on stderr, and all files are looked at.
[[nodiscard]] int run_check(const CheckOptions& options, Console& console);

}  // namespace tedavis::host_sim
