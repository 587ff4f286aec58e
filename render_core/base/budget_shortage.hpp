/// The sentence for a budget line that does not hold what its owner needs: the line, the bytes needed and those there.
///
/// Memory  inside the values, no heap. Thread  any. Failure  none: reading a sentence of another kind says so.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"

namespace tedavis::base {

/// Bytes. What an owner needs further on, after what did not fit, is not known yet.
struct BudgetShortage {
    FixedString<31> line;
    std::uint64_t left = 0, capacity = 0, needed = 0;

    /// The size of the line that holds what is needed beside what has been taken.
    [[nodiscard]] std::uint64_t enough() const { return capacity - left + needed; }
};

/// Returns "the budget line 'staging' has 10 of 20 bytes left and 30 are needed for PURPOSE; raise the line in the device file".
[[nodiscard]] Error shortage_error(const BudgetShortage& shortage, std::string_view purpose = {});
/// The same of a line that the owner charges itself.
[[nodiscard]] Error shortage_error(const BudgetLine& line, std::uint64_t needed, std::string_view purpose = {});
/// The same of a line's arena, which has refused something: needed is all that it has refused.
[[nodiscard]] Error shortage_error(std::string_view line, const Arena& arena, std::string_view purpose = {});
/// The same where less than `needed` bytes are left, by the arena or by the count of its owner.
[[nodiscard]] Error shortage_error(std::string_view line, const ResourceUse& use, std::uint64_t needed,
                                   std::string_view purpose = {});

/// Finds such a sentence in a message. Returns false where there is none.
[[nodiscard]] bool find_shortage(std::string_view message, BudgetShortage& shortage);

}  // namespace tedavis::base
