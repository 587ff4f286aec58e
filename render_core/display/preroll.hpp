/// Plans what lies before a frame that is shown.
#pragma once

#include "render_core/display/display.hpp"

namespace tedavis::display {

/// Plans a frame that counts as none. It needs to be drawn only where PlannerMemory::must_be_drawn() says so.
void preroll(Display& display, const flight::FrameInput& input);
/// Plans one instant, which follows from nothing, until all terrain that it needs has arrived; gives up after 64 times.
void settle(Display& display, const flight::FrameInput& input);

}  // namespace tedavis::display
