/// The machine's monotonic clock; only composition roots and live sources may read it.
#pragma once

#include "render_core/base/time.hpp"

namespace tedavis::platform {

/// Reads CLOCK_MONOTONIC, which never steps back.
[[nodiscard]] base::Time monotonic_now() noexcept;

}  // namespace tedavis::platform
