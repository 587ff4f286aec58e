/// The machine's monotonic clock; only composition roots and live sources may ask it.
#pragma once

#include "render_core/base/time.hpp"

namespace tedavis::platform {

/// CLOCK_MONOTONIC; never steps back.
[[nodiscard]] base::Time monotonic_now() noexcept;

}  // namespace tedavis::platform
