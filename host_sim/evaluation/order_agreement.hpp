/// Counts in how many pairs two measures give the same order.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

struct OrderAgreement {
    std::size_t pairs = 0;  ///< pairs that differ in the first measure
    std::size_t alike = 0;  ///< pairs of these that differ in the same direction in the second
};

/// Both lists have one value for each object.
[[nodiscard]] OrderAgreement order_agreement(const std::vector<double>& first, const std::vector<double>& second);

}  // namespace tedavis::host_sim
