/// `tedavis diff RUN_A RUN_B`: finds the first difference of two runs.
#pragma once

#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct DiffOptions {
    std::string run_a, run_b;  ///< folders that replay wrote
};

/// Returns 0 where all frames and records are equal (`ms` is ignored), 1 where they differ; throws UserError for bad input.
[[nodiscard]] int run_diff(const DiffOptions& options, Console& console);

}  // namespace tedavis::host_sim
