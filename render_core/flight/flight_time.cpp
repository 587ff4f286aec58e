#include "render_core/flight/flight_time.hpp"

#include "render_core/base/utc_time.hpp"

namespace tedavis::flight {

FlightTime time_of_source(base::Time now) noexcept {
    const bool is_date = base::can_be_utc(now);
    return {now, is_date, is_date};
}

FlightTime flight_time(const UtcEstimate& utc, base::Time now) noexcept {
    if (utc.state == base::SignalState::missing) return time_of_source(now);
    const base::Time time = now + utc.ahead;
    if (!base::can_be_utc(time)) return {now, false, false};
    return {time, true, utc.state == base::SignalState::valid};
}

}  // namespace tedavis::flight
