/// `tedavis replay --window`: the flight in a window on the screen.
#pragma once

#include <functional>
#include <memory>

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "platform/window/window_surface.hpp"

namespace tedavis::host_sim {

using WindowMaker = std::function<base::Result<std::unique_ptr<platform::Window>, base::Error>(const platform::SurfaceSettings&,
                                                                                               const char* title)>;

/// Runs until the window is closed or Ctrl-C. Returns the exit code. Throws UserError, also where there
/// is no screen; then nothing is written.
[[nodiscard]] int run_live_window(const ReplayOptions& options, Console& console,
                                  const WindowMaker& make_window = platform::make_window);

}  // namespace tedavis::host_sim
