/// The date and time of the flight, by which spatial data are valid and have an age. Pure; any thread.
#pragma once

#include "render_core/base/stamped.hpp"

namespace tedavis::flight {

/// What the aircraft's bus says of UTC.
struct UtcEstimate {
    base::Duration ahead;                                  ///< UTC minus the source's time
    base::SignalState state = base::SignalState::missing;  ///< missing: never known; valid; lost: not stated any more
};

struct FlightTime {
    base::Time utc;             ///< nanoseconds since 1970
    bool is_date = false;       ///< false: `utc` is the source's time, and no date
    bool is_confirmed = false;  ///< false: nobody states it any more; it goes on by the source's clock, and ages are unknown
};

/// By the source's own time, where that can be UTC: of a recording whose stamps are dates.
[[nodiscard]] FlightTime time_of_source(base::Time now) noexcept;
/// UTC as the bus states it, before all others; the source's own time only where the bus has never stated any.
[[nodiscard]] FlightTime flight_time(const UtcEstimate& utc, base::Time now) noexcept;

}  // namespace tedavis::flight
