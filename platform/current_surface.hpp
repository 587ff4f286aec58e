/// Which surface is current on this thread. "Current" is shared by all GL libraries of a process (releasing OSMesa's context
/// also releases EGL's), so a second surface is refused until the first is released.
///
/// Thread  each has its own. Memory  none.
#pragma once

#include "render_core/base/ports/surface.hpp"

namespace tedavis::platform {

/// False when another surface is current; true, and it holds, also when `surface` is current already.
[[nodiscard]] bool claim_current(const base::Surface* surface) noexcept;
/// Does nothing when `surface` is not the current one.
void drop_current(const base::Surface* surface) noexcept;
[[nodiscard]] bool is_current(const base::Surface* surface) noexcept;
[[nodiscard]] bool any_current() noexcept;

}  // namespace tedavis::platform
