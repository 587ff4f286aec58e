/// Chooses among the channels and identifiers that state one signal.
#pragma once

#include <cstddef>

#include "render_core/base/span.hpp"
#include "render_core/base/stamped.hpp"

namespace tedavis::bus {

/// Returns the index of the best candidate at `now`, in the order healthy and fresh, degraded, stale, stated invalid by its
/// sender, lost, never received. Among equals the first wins: pass candidates in order of preference. Returns 0 for an empty
/// span.
[[nodiscard]] std::size_t vote(base::Span<const base::Stamped<double>> candidates, base::Time now,
                               const base::FreshnessLimits& limits) noexcept;

}  // namespace tedavis::bus
