/// The members of an ensemble: their mean and spread, and the members that a scene keeps.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

/// One field per member, all with the same number of posts; NaN where a value is missing.
using Members = std::vector<std::vector<float>>;

/// Mean and spread of each post; missing where a member's value is missing. The spread is the sample standard deviation (with
/// divisor n - 1); NaN for a single member.
struct EnsembleMean {
    std::vector<float> mean, spread;
};
/// Returns the mean of one member or more.
[[nodiscard]] EnsembleMean mean_of(const Members& members);

/// Adds to each member's sum its values at the posts where none is missing; `sums` is empty before the first call.
void add_to_sums(const Members& members, std::vector<double>& sums);
/// Returns the members that are kept, ascending by their sums: `most` of them, evenly spaced by rank, including the least and the
/// greatest; all where there are at most `most`, which is 2 or more. Equal sums keep their order.
[[nodiscard]] std::vector<std::size_t> evenly_by_rank(const std::vector<double>& sums, std::size_t most);

}  // namespace tedavis::host_sim
