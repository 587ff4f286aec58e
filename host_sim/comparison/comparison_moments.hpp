/// The instants that the page of a comparison shows as pictures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

struct ComparisonMoment {
    std::size_t instant = 0;
    std::vector<std::string> reasons;  ///< "A is closest to the ground"; empty of those that are evenly spread
};

/// In the order of the instants, each at most once, those alone of which both runs have the picture: some that are evenly spread,
/// the first and the last of those with a position among them, where each run is closest to the ground, where quantities differ
/// most, and the first difference of alerts and of phases.
[[nodiscard]] std::vector<ComparisonMoment> comparison_moments(const RunComparison& runs);

}  // namespace tedavis::host_sim
