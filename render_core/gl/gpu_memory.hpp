/// Charges GPU bytes to a line of the budget table and releases them.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"

namespace tedavis::gl {

/// Charges bytes to a line. Returns false, and counts a refusal on the line, when too few are left.
[[nodiscard]] bool try_take(base::BudgetLine& line, std::uint64_t bytes);
void give_back(base::BudgetLine& line, std::uint64_t bytes);

}  // namespace tedavis::gl
