/// Converts between calendar dates (proleptic Gregorian, UTC, no leap seconds) and instants since the Unix epoch.
#pragma once

#include <optional>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Returns the instant of midnight UTC; nothing for a date that does not exist. Years 1900..2199.
[[nodiscard]] std::optional<base::Time> midnight_of(int year, int month, int day);
struct CalendarDate {
    int year = 1970, month = 1, day = 1;
    int second_of_day = 0;
};
/// Returns the UTC date and the whole seconds since its midnight; years 1900..2199.
[[nodiscard]] CalendarDate calendar_date(base::Time time);
/// Parses ISO 8601 "2020-04-12T09:47:00[.fraction][Z|+hh:mm]"; a missing zone means UTC. Returns nothing for other text.
[[nodiscard]] std::optional<base::Time> parse_iso8601(std::string_view text);
/// Parses seconds since 1970 UTC with a decimal fraction, exactly to the nanosecond (a double would not suffice). Returns nothing
/// for other text and beyond +-7e9 s.
[[nodiscard]] std::optional<base::Time> parse_unix_seconds(std::string_view text);

}  // namespace tedavis::host_sim
