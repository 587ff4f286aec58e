/// Describes in sentences how the heights of two runs were measured, and where the ground below is known.
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
/// States where heights are pressure altitudes, or such taken for heights above sea level, and where only parts of a run are over
/// known ground. Empty where all heights are geometric and the ground is known everywhere, or nowhere in both runs.
[[nodiscard]] std::vector<std::string> height_sentences(const RunComparison& runs);

}  // namespace tedavis::host_sim
