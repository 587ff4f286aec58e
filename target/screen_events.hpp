/// Writes to the event log when the board's screen is unplugged, taken away by another program, and when it is back: one line
/// each.
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
    /// After each frame. Nothing is written where nothing has changed.
    void report(const platform::ScreenReport& screen);

private:
    const EventLog& log_;
    bool was_plugged_ = true, was_master_ = true, was_stuck_ = false;
};

}  // namespace tedavis::target
