/// How long this process has run, loading of its libraries included.
#pragma once

#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::target {

/// In steps of the kernel's clock tick (10 ms as a rule); 0 where /proc does not say. Never allocates.
[[nodiscard]] base::Duration process_age();

/// Returns the start of a process in clock ticks since boot, from the text of /proc/PID/stat; 0 where it is not there.
[[nodiscard]] std::uint64_t start_ticks(std::string_view stat);

}  // namespace tedavis::target
