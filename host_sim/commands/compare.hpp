/// `tedavis compare RUN_A RUN_B -o page.html`: two runs on one page.
#pragma once

#include <string>

#include "host_sim/comparison/alignment.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct CompareOptions {
    std::string run_a, run_b;  ///< folders that replay or fly wrote
    std::string output;        ///< the page; compare.json is written beside it
    AlignmentRequest align;
};

inline constexpr char kCompareJsonName[] = "compare.json";

/// Returns 0. Throws UserError for bad input; then no file is written in part.
[[nodiscard]] int run_compare(const CompareOptions& options, Console& console);

}  // namespace tedavis::host_sim
