/// The half seconds of the source's time, counted from its zero, at whose first instants the display decides labels, priorities
/// and the terrain alert: decisions that follow from the interval alone are the same however a frame is reached.
#pragma once

#include "render_core/base/time.hpp"

namespace tedavis::flight {

inline constexpr base::Duration kDecisionInterval = base::Duration::milliseconds(500);

/// The number of the interval that an instant lies in; negative before the source's zero.
[[nodiscard]] constexpr std::int64_t decision_interval_of(base::Time now) {
    const std::int64_t number = now.ns / kDecisionInterval.ns;
    return now.ns < number * kDecisionInterval.ns ? number - 1 : number;
}

}  // namespace tedavis::flight
