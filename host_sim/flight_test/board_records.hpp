/// The records of a running display one after the other, none of them missing. Those of before are left out: while nobody reads,
/// they pile up, and the last of them are dropped.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/board_record.hpp"

namespace tedavis::host_sim {

/// A display that says nothing for so long is gone: a driver may compile for some seconds.
inline constexpr base::Duration kLongestWithoutRecord = base::Duration::seconds(20);

/// Throws UserError where the screen has not confirmed the picture of this frame. `display`: its socket.
void require_on_screen(const BoardRecord& record, const std::string& display);

class BoardRecords {
public:
    /// `display`: its socket, for sentences. All must outlive this object.
    BoardRecords(BoardPort& port, const std::string& display, const std::function<bool()>& is_interrupted)
        : port_(port), display_(display), is_interrupted_(is_interrupted), begun_(port.now()), heard_(begun_) {}

    /// Waits until one comes, or the time has; nothing: none came, or one of before this object. Throws UserError where records
    /// are missing, BoardLost where the display is silent or gone, and Interrupted.
    [[nodiscard]] std::optional<BoardRecord> next(base::Time until);
    /// The last one as it came.
    [[nodiscard]] const std::string& packet() const { return packet_; }

private:
    BoardPort& port_;
    const std::string& display_;
    const std::function<bool()>& is_interrupted_;
    base::Time begun_, heard_;
    std::optional<std::uint64_t> last_frame_;
    std::string packet_;
};

}  // namespace tedavis::host_sim
