/// Port: the machine of a running display, as a flight test needs it. The program uses live_board.hpp, tests their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/frame/can_frame.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// No further test can be flown: the display or its bus is gone.
class BoardLost : public UserError {
public:
    using UserError::UserError;
};

class BoardPort {
public:
    virtual ~BoardPort() = default;
    /// CLOCK_MONOTONIC.
    [[nodiscard]] virtual base::Time now() = 0;
    /// Waits until a record of a frame comes, or the time has; nothing: none came. Throws BoardLost where the display is gone.
    [[nodiscard]] virtual std::optional<std::string> next_record(base::Time until) = 0;
    /// Onto the bus, at once. Throws BoardLost where the bus does not take it, UserError for a frame of CAN FD where it has none.
    virtual void send(const bus::CanFrame& frame) = 0;
    /// What others have sent since the last call, with times of the clock of now().
    [[nodiscard]] virtual std::vector<bus::CanFrame> take_received() = 0;
    /// Frames of others that the kernel had no room for, all in all.
    [[nodiscard]] virtual std::uint64_t dropped_frames() const = 0;
    [[nodiscard]] virtual bool has_panel() const = 0;
    /// A line of the board's panel, by its place in the panel's file; only with a panel. Throws BoardLost.
    virtual void set_line(std::size_t line, bool level) = 0;
};

}  // namespace tedavis::host_sim
