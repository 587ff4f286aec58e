/// Plans frames before the first one that is shown.
#pragma once

#include "render_core/display/display.hpp"

namespace tedavis::display {

/// Plans a frame that is not counted. It needs to be drawn only where PlannerMemory::must_be_drawn() says so.
void preroll(Display& display, const flight::FrameInput& input);
/// Plans one instant, independent of earlier frames, until all terrain that it needs has arrived; gives up after 64 attempts.
void settle(Display& display, const flight::FrameInput& input);

}  // namespace tedavis::display
