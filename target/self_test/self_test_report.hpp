/// What the self-test found, check by check.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::target {

struct SelfCheck {
    base::FixedString<31> name;
    bool holds = false;
    base::FixedString<511> finding;  ///< what was found, and what was expected where it is not that
};

/// Thread  one. Memory  inside. A check too many counts as one that does not hold.
class SelfTestReport {
public:
    void add(std::string_view name, bool holds, std::string_view finding);
    /// "found 1.25 deg, expected 1.2 +- 0.1" with the unit behind each number; NaN never holds.
    void add_number(std::string_view name, double found, double expected, double tolerance, std::string_view unit);
    /// Found must lie in low .. high.
    void add_count(std::string_view name, std::uint64_t found, std::uint64_t low, std::uint64_t high);

    /// True when there is at least one check and all hold.
    [[nodiscard]] bool holds() const;
    [[nodiscard]] base::Span<const SelfCheck> checks() const { return {checks_.data(), checks_.size()}; }
    /// Null when there is none of this name.
    [[nodiscard]] const SelfCheck* find(std::string_view name) const;

private:
    base::FixedVector<SelfCheck, 64> checks_;
};

}  // namespace tedavis::target
