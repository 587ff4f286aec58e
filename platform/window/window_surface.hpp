/// A window on the desk's screen (SDL 2), with its GL ES context and its events.
///
/// Thread  the one that made it. Memory  allocates when made and inside SDL. One window a process.
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
    /// Takes what happened since the last call, oldest first, and returns how many were written; what does not fit waits.
    [[nodiscard]] virtual std::size_t poll_events(base::Span<WindowEvent> out) = 0;
    virtual void set_title(const char* title) = 0;
};

/// Refused in one sentence when the build has no SDL, when another surface is current, and when there is no screen: SDL then
/// silently picks a driver that shows nothing, which would look like success.
[[nodiscard]] base::Result<std::unique_ptr<Window>, base::Error> make_window(const SurfaceSettings& settings, const char* title);

}  // namespace tedavis::platform
