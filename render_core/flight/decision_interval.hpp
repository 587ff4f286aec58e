/// Decision intervals: half seconds of the source's time, counted from its zero. The display decides labels, priorities and the
/// terrain alert for the first instant of each, so these decisions do not depend on the frames drawn before.
#pragma once

#include "render_core/base/time.hpp"

namespace tedavis::flight {

inline constexpr base::Duration kDecisionInterval = base::Duration::milliseconds(500);

/// Returns the number of the interval that contains an instant; negative before the source's zero.
[[nodiscard]] constexpr std::int64_t decision_interval_of(base::Time now) {
    const std::int64_t number = now.ns / kDecisionInterval.ns;
    return now.ns < number * kDecisionInterval.ns ? number - 1 : number;
}

}  // namespace tedavis::flight
