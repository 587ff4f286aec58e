/// The results of the self-test, check by check.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::target {

struct SelfCheck {
    base::FixedString<31> name;
    bool holds = false;
    base::FixedString<511> finding;  ///< the value found, and the expected one where the check failed
};

/// Thread  one. Memory  inside. A check beyond the capacity counts as failed.
class SelfTestReport {
public:
    void add(std::string_view name, bool holds, std::string_view finding);
    /// Adds a check of a number; where it fails the finding is "1.25 deg, expected 1.2 +- 0.1". NaN always fails.
    void add_number(std::string_view name, double found, double expected, double tolerance, std::string_view unit);
    /// Adds a check that `found` lies in low .. high.
    void add_count(std::string_view name, std::uint64_t found, std::uint64_t low, std::uint64_t high);

    /// True when there is at least one check and all hold.
    [[nodiscard]] bool holds() const;
    [[nodiscard]] base::Span<const SelfCheck> checks() const { return {checks_.data(), checks_.size()}; }
    /// Returns the check of this name, or null.
    [[nodiscard]] const SelfCheck* find(std::string_view name) const;

private:
    base::FixedVector<SelfCheck, 128> checks_;
};

}  // namespace tedavis::target
