#include "host_sim/window/start_screen.hpp"

#include "host_sim/replay/flight_player.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/window/window_overlay.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Duration kBetweenScreens = base::Duration::milliseconds(100);

}  // namespace

void StartScreen::show(std::uint64_t done, std::uint64_t total, base::Time now) {
    if (total < IndexPolicy().smallest_kept_log || (shown_ && now - *shown_ < kBetweenScreens)) return;
    shown_ = now;
    take_events();
    const WindowOverlay overlay{"WINDOW  INDEXING " + log_ + " " + std::to_string(100 * done / total) + " %", {}};
    std::vector<PaintedRect> rects{{0, 0, session_.width(), session_.height(), {}}};
    for (const PaintedRect& rect : overlay_rects(overlay, session_.width(), session_.height())) rects.push_back(rect);
    paint_rects(session_.display().gl(), session_.height(), rects);
    session_.present();
}

void StartScreen::take_events() {
    platform::WindowEvent event;
    while (window_.poll_events({&event, 1}) == 1) {
        const bool is_escape = event.kind == platform::WindowEventKind::key_down && event.key == platform::Key::escape;
        if (is_escape || event.kind == platform::WindowEventKind::closed)
            throw Interrupted(log_ + ": the window was closed while it was indexed; nothing was written");
        events_.push_back(event);
    }
}

}  // namespace tedavis::host_sim
