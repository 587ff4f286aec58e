/// Port: what a display needs from a seat manager, by libseat. Thin, so that tests play managers that this machine does not have.
///
/// Thread  one at a time. Memory  libseat's, which counts as the driver's.
#pragma once

#include <memory>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

/// What the manager says, from within open() and dispatch() alone.
class SeatListener {
public:
    virtual void on_enable() = 0;
    /// The manager waits for SeatPort::disable().
    virtual void on_disable() = 0;

protected:
    ~SeatListener() = default;
};

class SeatPort {
public:
    virtual ~SeatPort() = default;
    /// Waits for the manager's answer without a limit. False: no manager gives a seat. `listener` must outlive the seat.
    [[nodiscard]] virtual bool open(SeatListener& listener) = 0;
    /// Waits without a limit; the seat must be enabled. Returns the device's number and its descriptor, or -1 with errno.
    [[nodiscard]] virtual int open_device(const char* path, int& descriptor) = 0;
    virtual void close_device(int device) = 0;
    /// Says that the screen is not used any more; the manager answers by on_enable() when it may be used again. With libseat 0.8
    /// the seatd backend waits here for the manager without a limit; that of libseat 0.7 does not wait.
    [[nodiscard]] virtual bool disable() = 0;
    /// Hands on what the manager has said, and waits for it for at most `wait_ms`. False: the manager is gone. The backend for
    /// logind may wait longer, since it answers logind by a call of D-Bus.
    [[nodiscard]] virtual bool dispatch(int wait_ms) = 0;
    virtual void close() = 0;
    /// "seatd"; empty before open().
    [[nodiscard]] virtual base::FixedString<31> manager() const = 0;
};

/// Null where libseat was missing at the build, and without memory.
[[nodiscard]] std::unique_ptr<SeatPort> make_libseat_port();

}  // namespace tedavis::platform
