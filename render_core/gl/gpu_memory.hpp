/// Takes GPU bytes from a line of the budget table and gives them back.
#pragma once

#include <cstdint>

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"

namespace tedavis::gl {

/// False (and one more refusal on the line) when the line has not so many bytes left.
[[nodiscard]] bool try_take(base::BudgetLine& line, std::uint64_t bytes);
void give_back(base::BudgetLine& line, std::uint64_t bytes);
/// "the budget line 'font_atlas' has 10 of 20 bytes left, 30 are needed; raise it in the device file"
[[nodiscard]] base::Error over_budget(const base::BudgetLine& line, std::uint64_t needed);

}  // namespace tedavis::gl
