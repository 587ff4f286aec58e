/// An instant of UTC as files write it. Pure function; any thread; allocates nothing.
#pragma once

#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// Reads "2026-06-01T14:00:00Z", exactly so: years 1970..2199, proleptic Gregorian, no leap seconds. False, and `time` stays,
/// for anything else.
[[nodiscard]] bool parse_utc(std::string_view text, Time& time) noexcept;

}  // namespace tedavis::base
