/// Sends signs of life to the service manager: "ready", "alive" and "stopping", as systemd's sd_notify(3) defines them.
///
/// Without a manager (NOTIFY_SOCKET is not set) it does nothing. Every drawn frame is a sign of life, so a display that
/// hangs is restarted. A GL driver may compile for longer than the manager's limit (WATCHDOG_USEC of the environment) at the
/// start and where a design is first drawn: the manager is told to wait for kPatience_us until frames are quick again.
/// Thread  one. Memory  none; never allocates. Failure  silent: the manager then restarts.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::target {

class Watchdog {
public:
    static constexpr std::uint64_t kPatience_us = 60'000'000;
    /// So many frames in a row, each within kQuick, end the patience.
    static constexpr int kQuickFrames = 10;
    static constexpr base::Duration kQuick = base::Duration::seconds(1);

    /// Takes the manager's socket and limit from the environment.
    Watchdog();
    /// A name that begins with '@' is in the abstract namespace; with an empty or impossible name the object does nothing.
    /// `limit_us`  microseconds that the manager waits for a sign of life; 0: it does not.
    explicit Watchdog(std::string_view socket_path, std::uint64_t limit_us = 0);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// The first frame was shown.
    void ready();
    /// What is drawn next may be new to the GL driver.
    void expect_slow_frames();
    /// A frame was drawn, which took so long.
    void alive(base::Duration took);
    void stopping() const { send("STOPPING=1\n"); }
    [[nodiscard]] bool connected() const { return descriptor_ >= 0; }

private:
    void connect_to(std::string_view socket_path);
    void send(std::string_view message) const;
    void set_limit(std::uint64_t limit_us) const;
    int descriptor_ = -1;
    std::uint64_t limit_us_ = 0;
    bool is_patient_ = false;
    int quick_frames_ = 0;
};

}  // namespace tedavis::target
