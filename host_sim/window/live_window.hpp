/// Shows the flight of `tedavis replay --window` in a window on the screen.
#pragma once

#include <functional>
#include <memory>

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "platform/window/window_surface.hpp"

namespace tedavis::host_sim {

using WindowMaker = std::function<base::Result<std::unique_ptr<platform::Window>, base::Error>(const platform::SurfaceSettings&,
                                                                                               const char* title)>;

/// Runs until the user closes the window or presses Ctrl-C, and returns the exit code. Throws UserError; if the reason is that
/// there is no screen, nothing has been written.
[[nodiscard]] int run_live_window(const ReplayOptions& options, Console& console,
                                  const WindowMaker& make_window = platform::make_window);

}  // namespace tedavis::host_sim
