/// What the window shows while a large log is indexed: a line that says how far it is. Keys that are pressed meanwhile are kept
/// for the run. A small log takes a moment; nothing is shown, and its events stay in the window.
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
    /// `log`: its name, as the line says it. Window and session must outlive the screen.
    StartScreen(platform::Window& window, DisplaySession& session, std::string log)
        : window_(window), session_(session), log_(std::move(log)) {}

    /// Of a log of `total` bytes `done` are read, at `now` of any clock. Throws Interrupted where the window is closed, by its
    /// button or by escape.
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
