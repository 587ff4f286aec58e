/// Translates SDL events into WindowEvent.
#pragma once

#include "platform/window/window_events.hpp"

union SDL_Event;

namespace tedavis::platform {

/// Returns false for an event that the program does not use.
[[nodiscard]] bool translate_event(const SDL_Event& from, WindowEvent& to);

}  // namespace tedavis::platform
