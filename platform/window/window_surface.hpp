/// A window on the desktop (SDL 2) with its GL ES context and its events.
///
/// Thread  the one that created it. Memory  allocates when created, and inside SDL. At most one window exists in a process.
#pragma once

#include <cstddef>
#include <memory>

#include "platform/surface_settings.hpp"
#include "platform/window/window_events.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::platform {

class Window : public base::Surface {
public:
    /// Writes the events since the last call, oldest first, and returns their number; events that do not fit are returned by
    /// the next call.
    [[nodiscard]] virtual std::size_t poll_events(base::Span<WindowEvent> out) = 0;
    virtual void set_title(const char* title) = 0;
};

/// Fails with one sentence when the build has no SDL, when another surface is current, and when there is no screen (SDL would
/// silently choose a driver that shows nothing).
[[nodiscard]] base::Result<std::unique_ptr<Window>, base::Error> make_window(const SurfaceSettings& settings, const char* title);

}  // namespace tedavis::platform
