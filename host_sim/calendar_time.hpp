/// Converts between calendar dates (proleptic Gregorian, UTC, no leap seconds) and instants since the Unix epoch.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Returns the instant at which the date begins (midnight UTC), or nothing if the date does not exist or its year is not
/// 1900..2199.
[[nodiscard]] std::optional<base::Time> midnight_of(int year, int month, int day);
struct CalendarDate {
    int year = 1970, month = 1, day = 1;
    int second_of_day = 0;
};
/// Returns the UTC date of an instant, and the whole seconds since that date began. For years 1900..2199.
[[nodiscard]] CalendarDate calendar_date(base::Time time);
/// "2026-06-01T14:00:00Z": the whole second. For years 1900..2199.
[[nodiscard]] std::string utc_text(base::Time time);
/// Now, by the machine's clock.
[[nodiscard]] std::string utc_now();
/// Parses ISO 8601 "2020-04-12T09:47:00[.fraction][Z|+hh:mm|-hh:mm]"; without a zone it is UTC. The "T" may be a space. Returns
/// nothing for any other text.
[[nodiscard]] std::optional<base::Time> parse_iso8601(std::string_view text);
/// Parses seconds since 1970 UTC with a decimal fraction, exactly to the nanosecond (a double would not suffice). Returns nothing
/// for any other text, and for more than 7e9 s before or after 1970.
[[nodiscard]] std::optional<base::Time> parse_unix_seconds(std::string_view text);

}  // namespace tedavis::host_sim
