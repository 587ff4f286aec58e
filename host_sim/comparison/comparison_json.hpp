/// `compare.json`: a comparison for scripts.
#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

/// `comparison` (title), `sentences`, `warnings`, `equal`, `a`, `b` (folder and names of the summary), `alignment`,
/// `compared_frames` (how many frames of each run, each once), `heights` (`are_assumed`: pressure altitudes taken for heights
/// above sea level; in how many frames of each run they are pressure altitudes alone, and in how many the ground below is known),
/// `closest` (of each whole run), `differences` (one for each quantity), `effects` and `alerts` (in compared frames), and
/// `instants`: both frames with their values, in SI units. Values that are not known are null.
[[nodiscard]] nlohmann::ordered_json comparison_json(const RunComparison& runs);

}  // namespace tedavis::host_sim
