/// Days of UTC as text, and their instants, by the proleptic Gregorian calendar. Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::platform {

inline constexpr base::Duration kUtcDay = base::Duration::seconds(86'400);

/// A UTC day as "2026-12-28"; empty: none.
using DayText = base::FixedString<10>;
/// True for a day that exists, from 1970 to 2199.
[[nodiscard]] bool is_day(std::string_view text);
/// The day of an instant, in ns since 1970 UTC.
[[nodiscard]] DayText day_of(std::int64_t unix_ns);
/// The first instant of a day, for which is_day() must hold, in ns since 1970 UTC.
[[nodiscard]] base::Time start_of_day(std::string_view day);

}  // namespace tedavis::platform
