/// An instant of UTC: as files write it, and whether one can be. Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// Reads "2026-06-01T14:00:00Z", exactly so: years 1970..2199, proleptic Gregorian, no leap seconds. False, and `time` stays,
/// for anything else.
[[nodiscard]] bool parse_utc(std::string_view text, Time& time) noexcept;

/// Days from 1970-01-01 to a date of the Gregorian calendar, years 1970..2199, month and day from 1. False, and `days` stays, for
/// a date that the calendar has not.
[[nodiscard]] bool days_to_date(int year, int month, int day, std::int64_t& days) noexcept;

/// True for 2000-01-01 to 2100-01-01 as nanoseconds since 1970: what a log with stamps from zero, or a board that has lost its
/// clock, never shows.
[[nodiscard]] bool can_be_utc(Time time) noexcept;

/// Of an instant in nanoseconds since 1970.
[[nodiscard]] inline double seconds_since_1970(Time utc) noexcept { return static_cast<double>(utc.ns) / 1e9; }

}  // namespace tedavis::base
