/// Interface to the machine of a running display. The program implements it in live_board.hpp, tests by fakes.
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

/// Thrown where no further test can be flown, since the display or its bus is gone.
class BoardLost : public UserError {
public:
    using UserError::UserError;
};

class BoardPort {
public:
    virtual ~BoardPort() = default;
    /// The time of CLOCK_MONOTONIC.
    [[nodiscard]] virtual base::Time now() = 0;
    /// Waits for the next record of a frame until `until` at the latest; nothing: none was received. Throws BoardLost where the
    /// display is gone.
    [[nodiscard]] virtual std::optional<std::string> next_record(base::Time until) = 0;
    /// Sends a frame at once. Throws BoardLost where the bus does not accept it, UserError for a CAN FD frame on a bus without
    /// CAN FD.
    virtual void send(const bus::CanFrame& frame) = 0;
    /// Returns the frames that others have sent since the last call, with stamps of the clock of now().
    [[nodiscard]] virtual std::vector<bus::CanFrame> take_received() = 0;
    /// Number of received frames that the kernel has dropped since the bus was opened.
    [[nodiscard]] virtual std::uint64_t dropped_frames() const = 0;
    [[nodiscard]] virtual bool has_panel() const = 0;
    /// Sets a line of the board's panel, which is numbered from 0 in the order of the panel's file. Only where has_panel().
    /// Throws BoardLost.
    virtual void set_line(std::size_t line, bool level) = 0;
};

}  // namespace tedavis::host_sim
