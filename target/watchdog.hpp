/// Sends signs of life to the service manager: "ready", "alive" and "stopping", as systemd's sd_notify(3) defines them.
///
/// Without a manager (NOTIFY_SOCKET is not set) it does nothing. Every drawn frame is a sign of life, so a display that
/// hangs is restarted. Thread  one. Memory  none; never allocates. Failure  silent: the manager then restarts.
#pragma once

#include <string_view>

namespace tedavis::target {

class Watchdog {
public:
    /// Takes the manager's socket from the environment.
    Watchdog();
    /// A name that begins with '@' is in the abstract namespace; with an empty or impossible name the object does nothing.
    explicit Watchdog(std::string_view socket_path);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    void ready() const { send("READY=1\nSTATUS=displaying\n"); }
    void alive() const { send("WATCHDOG=1\n"); }
    void stopping() const { send("STOPPING=1\n"); }
    [[nodiscard]] bool connected() const { return descriptor_ >= 0; }

private:
    void connect_to(std::string_view socket_path);
    void send(std::string_view message) const;
    int descriptor_ = -1;
};

}  // namespace tedavis::target
