/// `tedavis evaluate IMAGE...|RUN [RUN] -o DIR`: measures clutter and saliency of pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/console.hpp"
#include "render_core/perception/edge_detector.hpp"

namespace tedavis::host_sim {

struct EvaluateOptions {
    std::vector<std::string> inputs;                 ///< pictures and folders of sheets, or one folder that replay wrote, or two
    std::string output;                              ///< folder
    std::string fixations;                           ///< CSV; empty: none
    std::string orderings;                           ///< of pictures: shipped name of configs/orderings, or a path; empty: none
    std::optional<perception::CannySettings> canny;  ///< nothing: the orderings', else the default
    std::uint32_t threads = 0;                       ///< 0: as many as there are processors
};

/// Writes evaluation.json and the views of pictures, for runs report.html with the views of their peaks. Returns the exit code,
/// kInterruptedExitCode with a valid result so far; throws UserError and Interrupted.
[[nodiscard]] int run_evaluate(const EvaluateOptions& options, Console& console);

}  // namespace tedavis::host_sim
