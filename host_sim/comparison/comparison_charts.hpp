/// The curves of a comparison, as HTML.
#pragma once

#include <string>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

inline constexpr char kColorOfA[] = "#3a78c2", kColorOfB[] = "#c8641b";

/// A chart for each quantity that both runs know, with both curves; below it B minus A where that is not 0 everywhere. No
/// line joins instants that are much farther apart in the time of A than is usual.
[[nodiscard]] std::string comparison_charts(const RunComparison& runs);
/// Phases and alerts of both runs below each other; empty for a single instant.
[[nodiscard]] std::string comparison_states(const RunComparison& runs);

}  // namespace tedavis::host_sim
