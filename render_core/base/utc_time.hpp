/// UTC instants: parsing, and a plausibility check. Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// Parses exactly the form "2026-06-01T14:00:00Z": years 1970..2199, proleptic Gregorian, no leap seconds. Returns false, and
/// leaves `time` unchanged, for anything else.
[[nodiscard]] bool parse_utc(std::string_view text, Time& time) noexcept;

/// Computes the days from 1970-01-01 to a date of the Gregorian calendar, years 1970..2199, month and day from 1. Returns
/// false, and leaves `days` unchanged, for a date that does not exist.
[[nodiscard]] bool days_to_date(int year, int month, int day, std::int64_t& days) noexcept;

/// True for times from 2000-01-01 to 2100-01-01, in nanoseconds since 1970. Logs with stamps from zero, and boards that have
/// lost their clock, lie outside.
[[nodiscard]] bool can_be_utc(Time time) noexcept;

/// Converts an instant in nanoseconds since 1970.
[[nodiscard]] inline double seconds_since_1970(Time utc) noexcept { return static_cast<double>(utc.ns) / 1e9; }

}  // namespace tedavis::base
