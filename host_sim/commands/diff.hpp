/// `tedavis diff RUN_A RUN_B`: where two runs first differ.
#pragma once

#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct DiffOptions {
    std::string run_a, run_b;  ///< folders that replay wrote
};

/// 0 where all frames and records are the same (`ms` ignored), 1 where they differ; throws UserError for bad input.
[[nodiscard]] int run_diff(const DiffOptions& options, Console& console);

}  // namespace tedavis::host_sim
