#include "render_core/display/preroll.hpp"

namespace tedavis::display {

void preroll(Display& display, const flight::FrameInput& input) {
    const std::uint64_t frames = display.memory().frames;
    display.plan(input);
    display.memory().frames = frames;
}

void settle(Display& display, const flight::FrameInput& input) {
    constexpr int kMaxTimes = 64;
    display.memory().cut();
    for (int n = 0; n < kMaxTimes; ++n) {
        preroll(display, input);
        if (display.planned().terrain.pending == 0) return;
    }
}

}  // namespace tedavis::display
