/// The instants that the page of a comparison shows as pictures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

struct ComparisonMoment {
    std::size_t instant = 0;
    std::vector<std::string> reasons;  ///< "A is closest to the ground"; empty for evenly spread ones
};

/// Returns instants of which both runs have the picture, ascending and without duplicates: some that are evenly spread, among
/// them the first and the last with a position; those at which each run is closest to the ground or a quantity differs most; and
/// the first differences of alerts and of phases.
[[nodiscard]] std::vector<ComparisonMoment> comparison_moments(const RunComparison& runs);

}  // namespace tedavis::host_sim
