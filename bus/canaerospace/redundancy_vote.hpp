/// Chooses among the channels and identifiers that state one signal.
#pragma once

#include <cstddef>

#include "render_core/base/span.hpp"
#include "render_core/base/stamped.hpp"

namespace tedavis::bus {

/// Index of the candidate to believe at `now`: healthy and fresh before degraded, before stale, before one whose sender
/// says invalid, before lost, before never received. Among equals the first wins, so candidates are passed in order of
/// preference. 0 for an empty span.
[[nodiscard]] std::size_t vote(base::Span<const base::Stamped<double>> candidates, base::Time now,
                               const base::FreshnessLimits& limits) noexcept;

}  // namespace tedavis::bus
