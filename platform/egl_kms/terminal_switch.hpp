/// Learns from the console when somebody switches to another virtual terminal (Alt+F2) and back, so that the screen can be given
/// up and taken again. Without a virtual terminal as the controlling one there is nothing to learn.
///
/// Signals  release_signal() and acquire_signal() while it is active: real-time signals, since target/snapshot has SIGUSR1.
/// Thread  one; only one object may be active at a time. Memory  none.
#pragma once

#include <signal.h>

#include "platform/egl_kms/drm_port.hpp"

namespace tedavis::platform {

class TerminalSwitch {
public:
    TerminalSwitch() = default;
    ~TerminalSwitch() { stop(); }
    TerminalSwitch(const TerminalSwitch&) = delete;
    TerminalSwitch& operator=(const TerminalSwitch&) = delete;

    /// Asks the console to be told. False where `path` is no virtual terminal; nothing has changed then.
    bool start(const char* path = "/dev/tty");
    /// The console switches by itself again.
    void stop();
    [[nodiscard]] bool is_active() const { return terminal_ >= 0; }

    /// The newest request since the last call.
    [[nodiscard]] TerminalRequest take_request();
    /// Without an answer the console does not switch. False where it had not asked.
    [[nodiscard]] bool answer(TerminalRequest request);

    [[nodiscard]] static int release_signal() { return SIGRTMIN; }
    [[nodiscard]] static int acquire_signal() { return SIGRTMIN + 1; }

private:
    int terminal_ = -1;
    struct sigaction previous_release_ {};
    struct sigaction previous_acquire_ {};
};

}  // namespace tedavis::platform
