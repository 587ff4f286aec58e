#include "host_sim/flight_test/board_records.hpp"

#include "host_sim/flight_test/input_logs.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kRecordRounding_s = 1e-6;  // by which a record may miss a time, as its digits are rounded

}  // namespace

void require_on_screen(const BoardRecord& record, const std::string& display) {
    if (record.is_on_screen) return;
    throw UserError(display + ": frame " + std::to_string(record.frame) +
                    " is not on the screen, so nobody could see it; connect the screen, see that no other program has it, and "
                    "fly the test again");
}

std::optional<BoardRecord> BoardRecords::next(base::Time until) {
    if (is_interrupted_ && is_interrupted_()) throw Interrupted(kTestInterrupted);
    std::optional<std::string> packet = port_.next_record(until);
    if (!packet) {
        if (port_.now() - heard_ > kLongestWithoutRecord)
            throw BoardLost(display_ + ": the display said nothing for " +
                            std::to_string(kLongestWithoutRecord.ns / base::Duration::seconds(1).ns) +
                            " s; see whether it still draws, and fly the test again");
        return std::nullopt;
    }
    heard_ = port_.now();
    BoardRecord record = read_board_record(*packet, display_);
    if ((record.monotonic_s - (begun_ - base::Time{}).to_seconds()) < -kRecordRounding_s) return std::nullopt;
    if (last_frame_ && record.frame != *last_frame_ + 1)
        throw UserError(
            display_ + ": after frame " + std::to_string(*last_frame_) + " came the record of frame " +
            std::to_string(record.frame) +
            ": those between are missing, or the display was started again; end other programs and fly the test again");
    last_frame_ = record.frame;
    while (!packet->empty() && packet->back() == '\n') packet->pop_back();
    packet_ = std::move(*packet);
    return record;
}

}  // namespace tedavis::host_sim
