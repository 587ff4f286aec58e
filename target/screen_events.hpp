/// Writes to the event log which way the board's screen was opened, and when it is unplugged, taken away by another program, and
/// back, and when the seat manager ended: one line each.
///
/// Thread  one. Memory  inside.
#pragma once

#include "platform/egl_kms/screen_settings.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

class ScreenEvents {
public:
    /// `log` must outlive the object.
    explicit ScreenEvents(const EventLog& log) : log_(log) {}
    /// Once, when the screen is there.
    void started(const platform::ScreenReport& screen);
    /// After each frame. Nothing is written where nothing has changed.
    void report(const platform::ScreenReport& screen);

private:
    const EventLog& log_;
    platform::ManagerEnd manager_end_ = platform::ManagerEnd::none;
    bool was_plugged_ = true, was_master_ = true, was_stuck_ = false;
};

}  // namespace tedavis::target
