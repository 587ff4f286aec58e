/// The members of an ensemble: their mean and spread, and the members that a scene keeps.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

/// A field of as many posts each; NaN where missing.
using Members = std::vector<std::vector<float>>;

/// By post; missing where one of the members is. The spread is the standard deviation of the sample: divided by n - 1. One member
/// alone has none: NaN.
struct EnsembleMean {
    std::vector<float> mean, spread;
};
/// Of one member or more.
[[nodiscard]] EnsembleMean mean_of(const Members& members);

/// Adds to each member's sum its values at the posts where none is missing; `sums` is empty before the first call.
void add_to_sums(const Members& members, std::vector<double>& sums);
/// Which members are kept: `most` of them, evenly by the rank of their sums, with the least and the greatest; ascending, equal
/// ones in their order. All where there are no more than `most`, which is 2 or greater.
[[nodiscard]] std::vector<std::size_t> evenly_by_rank(const std::vector<double>& sums, std::size_t most);

}  // namespace tedavis::host_sim
