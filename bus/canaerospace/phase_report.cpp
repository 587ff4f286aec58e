#include "bus/canaerospace/phase_report.hpp"

#include "bus/canaerospace/data_type.hpp"
#include "bus/canaerospace/message_header.hpp"

namespace tedavis::bus {
namespace {

constexpr base::Duration kPeriod = base::Duration::seconds(1);

bool same(const flight::PhaseStatus& a, const flight::PhaseStatus& b) {
    return a.phase == b.phase && a.source == b.source && a.switch_fault == b.switch_fault && a.disagreement == b.disagreement;
}

}  // namespace

std::optional<CanFrame> PhaseReport::due(const flight::PhaseStatus& status, base::Time now) const noexcept {
    if (identifier_ == 0 || (has_sent_ && same(status, last_) && now - last_at_ < kPeriod)) return std::nullopt;
    CanFrame frame;
    frame.time = now;
    set_message_id(frame, identifier_, 0);
    write_header(frame, {node_, static_cast<std::uint8_t>(DataType::uchar8x4), 0, next_code_});
    const int faults = (status.switch_fault ? 1 : 0) | (status.disagreement ? 2 : 0);
    const TypedValue value{DataType::uchar8x4, 4, 0, {status.phase.code(), static_cast<std::int64_t>(status.source), faults, 0}};
    frame.length = static_cast<std::uint8_t>(kMessageHeaderBytes + encode_value(value, frame.data.data() + kMessageHeaderBytes));
    return frame;
}

void PhaseReport::sent(const flight::PhaseStatus& status, base::Time now) noexcept {
    ++next_code_;
    has_sent_ = true;
    last_ = status;
    last_at_ = now;
}

}  // namespace tedavis::bus
