/// A part of a flight.
#pragma once

#include <vector>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

struct TimeRange {
    base::Time from, to;  ///< both included

    [[nodiscard]] bool contains(base::Time time) const { return time >= from && time <= to; }
};

/// Ascending and disjoint.
using TimeRanges = std::vector<TimeRange>;

[[nodiscard]] inline bool contains(const TimeRanges& ranges, base::Time time) {
    for (const TimeRange& range : ranges)
        if (range.contains(time)) return true;
    return false;
}

}  // namespace tedavis::host_sim
