/// What the heights of two runs rest on, and where the ground below them is known, in sentences.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

/// Frames whose height is a pressure altitude alone.
[[nodiscard]] std::size_t frames_by_pressure(const ComparedRun& run);
/// Frames that know their height above the terrain.
[[nodiscard]] std::size_t frames_over_known_ground(const ComparedRun& run);
/// Where heights are pressure altitudes, or taken for what they are not, and where only parts of a run are over known ground.
/// Empty where all heights are geometric and the ground is known everywhere, or nowhere in both.
[[nodiscard]] std::vector<std::string> height_sentences(const RunComparison& runs);

}  // namespace tedavis::host_sim
