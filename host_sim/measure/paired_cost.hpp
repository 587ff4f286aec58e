/// effects::paired_cost() for lists whose length is not known before.
#pragma once

#include <vector>

#include "render_core/effects/paired_cost.hpp"

namespace tedavis::host_sim {

/// The n-th entries of both lists are a pair, ms.
[[nodiscard]] effects::PairedCost paired_cost(const std::vector<double>& with_ms, const std::vector<double>& without_ms);

}  // namespace tedavis::host_sim
