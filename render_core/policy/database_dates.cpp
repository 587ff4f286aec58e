#include "render_core/policy/database_dates.hpp"

namespace tedavis::policy {

base::Currency currency_of(const DatabaseDates& dates, const flight::FlightTime& time) noexcept {
    return time.is_date ? base::currency_at(dates.period, time.utc) : dates.at_start;
}

DatabaseDates dates_at_start(const base::ValidPeriod& period, base::Time utc) noexcept {
    return {period, currency_of({period}, flight::time_of_source(utc))};
}

}  // namespace tedavis::policy
