/// The date and time of the flight, from which validity and age of spatial data follow. Pure; any thread.
#pragma once

#include "render_core/base/stamped.hpp"

namespace tedavis::flight {

/// UTC as the aircraft's bus states it.
struct UtcEstimate {
    base::Duration ahead;                                  ///< UTC minus the source's time
    base::SignalState state = base::SignalState::missing;  ///< missing: never known; lost: no longer stated
};

struct FlightTime {
    base::Time utc;             ///< nanoseconds since 1970
    bool is_date = false;       ///< false: `utc` is the source's time and not a date
    bool is_confirmed = false;  ///< false: no longer stated; extrapolated with the source's clock, ages unknown
};

/// Uses the source's time where it can be UTC, as in a recording whose stamps are dates.
[[nodiscard]] FlightTime time_of_source(base::Time now) noexcept;
/// Uses UTC from the bus; the source's time only where the bus has never stated UTC.
[[nodiscard]] FlightTime flight_time(const UtcEstimate& utc, base::Time now) noexcept;

}  // namespace tedavis::flight
