/// Calendar dates (proleptic Gregorian, UTC, no leap seconds) as instants since the Unix epoch.
#pragma once

#include <optional>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Empty for a date that does not exist. Years 1900..2199.
[[nodiscard]] std::optional<base::Time> midnight_of(int year, int month, int day);
struct CalendarDate {
    int year = 1970, month = 1, day = 1;
    int second_of_day = 0;
};
/// UTC date and whole seconds since its midnight; years 1900..2199.
[[nodiscard]] CalendarDate calendar_date(base::Time time);
/// ISO 8601 "2020-04-12T09:47:00[.fraction][Z|+hh:mm]"; a missing zone means UTC.
[[nodiscard]] std::optional<base::Time> parse_iso8601(std::string_view text);
/// Seconds since 1970 UTC with a decimal fraction, exact to the nanosecond (a double is not). Empty beyond +-7e9 s.
[[nodiscard]] std::optional<base::Time> parse_unix_seconds(std::string_view text);

}  // namespace tedavis::host_sim
