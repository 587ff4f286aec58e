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
    std::vector<std::string> inputs;                 ///< pictures and folders of sheets, or one or two folders of replays
    std::string output;                              ///< folder
    std::string fixations;                           ///< CSV; empty: none
    std::string orderings;                           ///< of pictures: shipped name of configs/orderings, or a path; empty: none
    std::optional<perception::CannySettings> canny;  ///< empty: the settings of the orderings file, or else the default
    std::uint32_t threads = 0;                       ///< 0: as many as there are processors
};

/// Writes evaluation.json and the views of pictures, and, for runs, report.html with pictures of the frames of most clutter.
/// Returns the exit code; after Ctrl-C it is kInterruptedExitCode, and the files hold what was measured until then. Throws
/// UserError and Interrupted.
[[nodiscard]] int run_evaluate(const EvaluateOptions& options, Console& console);

}  // namespace tedavis::host_sim
