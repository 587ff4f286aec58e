/// Shows the progress in the window while a large log is indexed, and keeps the events of that time for the run. For a small log
/// nothing is shown, and the events stay in the window.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "platform/window/window_surface.hpp"

namespace tedavis::host_sim {

class StartScreen {
public:
    /// `log` is the log's name in the shown line. Window and session must outlive this object.
    StartScreen(platform::Window& window, DisplaySession& session, std::string log)
        : window_(window), session_(session), log_(std::move(log)) {}

    /// Shows that `done` of `total` bytes of the log are read, at `now` of any monotonic clock. Throws Interrupted where the
    /// window is closed, by its button or by escape.
    void show(std::uint64_t done, std::uint64_t total, base::Time now);
    /// The events so far, oldest first.
    [[nodiscard]] const std::vector<platform::WindowEvent>& events() const { return events_; }

private:
    void take_events();

    platform::Window& window_;
    DisplaySession& session_;
    std::string log_;
    std::vector<platform::WindowEvent> events_;
    std::optional<base::Time> shown_;
};

}  // namespace tedavis::host_sim
