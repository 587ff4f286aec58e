/// The curves of a comparison, as HTML.
#pragma once

#include <string>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

inline constexpr char kColorOfA[] = "#3a78c2", kColorOfB[] = "#c8641b";

/// Returns a chart with both curves for each quantity that both runs have, and below it B minus A if that is not 0 everywhere.
/// Curves are interrupted where instants are much farther apart in the time of A than usual.
[[nodiscard]] std::string comparison_charts(const RunComparison& runs);
/// Phases and alerts of both runs below each other; empty for a single instant.
[[nodiscard]] std::string comparison_states(const RunComparison& runs);

}  // namespace tedavis::host_sim
