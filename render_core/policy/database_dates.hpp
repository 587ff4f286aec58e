/// Decides whether the dates of a display's databases allow their use. Pure functions; any thread.
///
/// The date of a frame decides (flight/flight_time.hpp). After UTC is lost, the date goes on by the source's clock, so that what
/// was expired stays expired, and databases expire at midnight as before.
#pragma once

#include <type_traits>

#include "render_core/base/valid_period.hpp"
#include "render_core/flight/flight_time.hpp"

namespace tedavis::policy {

/// By default there are no dates, and the databases may be used always.
struct DatabaseDates {
    base::ValidPeriod period;  ///< in which all databases may be used
    /// Used in frames whose time is no date: the result of the check when the display was started.
    base::Currency at_start = base::Currency::current;
};
static_assert(std::is_trivially_copyable_v<DatabaseDates>);

[[nodiscard]] base::Currency currency_of(const DatabaseDates& dates, const flight::FlightTime& time) noexcept;

/// The dates of a display that is started at `utc` of a clock. A clock that was never set (base::can_be_utc) decides nothing.
[[nodiscard]] DatabaseDates dates_at_start(const base::ValidPeriod& period, base::Time utc) noexcept;

}  // namespace tedavis::policy
