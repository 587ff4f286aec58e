/// Reads the records of a running display in their order and checks that none is missing. Records of frames before this object
/// was made are skipped: the socket's queue fills while nobody reads it, and then loses the newest.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/board_record.hpp"

namespace tedavis::host_sim {

/// A display that sends no record for this time is regarded as gone. A GL driver may compile for some seconds.
inline constexpr base::Duration kLongestWithoutRecord = base::Duration::seconds(20);

/// Throws UserError where the screen has not confirmed the picture of this frame. `display`: its socket.
void require_on_screen(const BoardRecord& record, const std::string& display);

class BoardRecords {
public:
    /// `display` is the path of its socket, for messages. All arguments must outlive this object.
    BoardRecords(BoardPort& port, const std::string& display, const std::function<bool()>& is_interrupted)
        : port_(port), display_(display), is_interrupted_(is_interrupted), begun_(port.now()), heard_(begun_) {}

    /// Waits for the next record until `until` at the latest; nothing: none was received, or one of a frame before this object
    /// was made. Throws UserError where records are missing, BoardLost where the display is silent or gone, and Interrupted.
    [[nodiscard]] std::optional<BoardRecord> next(base::Time until);
    /// The last packet, unparsed.
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
