/// The period in which data may be used, and whether an instant lies in it. Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// Instants in nanoseconds since 1970 UTC. The period is open on a side whose instant is not stated.
struct ValidPeriod {
    std::optional<Time> begin;  ///< the first instant at which the data may be used
    std::optional<Time> end;    ///< the first instant after it at which they may no longer be used
};
static_assert(std::is_trivially_copyable_v<ValidPeriod>);

/// Whether data may be used, by their period.
enum class Currency : std::uint8_t { current, not_yet_valid, expired };

/// Before `begin` the data are not yet valid, also where the period ends before it begins.
[[nodiscard]] Currency currency_at(const ValidPeriod& period, Time utc) noexcept;

}  // namespace tedavis::base
