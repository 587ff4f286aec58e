/// Records which surface is current on this thread. "Current" is shared by all GL libraries of a process (releasing OSMesa's
/// context also releases EGL's), so a second surface is refused until the first is released.
///
/// Thread  each thread has its own record. Memory  none.
#pragma once

#include "render_core/base/ports/surface.hpp"

namespace tedavis::platform {

/// Makes `surface` the current one; true also when it already is. Returns false when another surface is current.
[[nodiscard]] bool claim_current(const base::Surface* surface) noexcept;
/// Does nothing when `surface` is not the current one.
void drop_current(const base::Surface* surface) noexcept;
[[nodiscard]] bool is_current(const base::Surface* surface) noexcept;
[[nodiscard]] bool any_current() noexcept;

}  // namespace tedavis::platform
