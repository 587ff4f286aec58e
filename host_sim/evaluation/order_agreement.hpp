/// Whether two measures put things in the same order.
#pragma once

#include <cstddef>
#include <vector>

namespace tedavis::host_sim {

struct OrderAgreement {
    std::size_t pairs = 0;  ///< that differ in the first measure
    std::size_t alike = 0;  ///< of them, those that differ in the same direction in the second
};

/// Both have a value for each thing.
[[nodiscard]] OrderAgreement order_agreement(const std::vector<double>& first, const std::vector<double>& second);

}  // namespace tedavis::host_sim
