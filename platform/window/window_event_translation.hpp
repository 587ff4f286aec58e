/// From SDL's events to ours.
#pragma once

#include "platform/window/window_events.hpp"

union SDL_Event;

namespace tedavis::platform {

/// False for an event that nobody here listens to.
[[nodiscard]] bool translate_event(const SDL_Event& from, WindowEvent& to);

}  // namespace tedavis::platform
