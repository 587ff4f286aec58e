#include "bus/canaerospace/message_header.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint32_t kHighestIdentifier = 2031;  // 2032..2047 are invalid in CAN 2.0 identifiers of the standard

}  // namespace

MessageId message_id(std::uint32_t can_id, bool extended) noexcept {
    const std::uint32_t identifier = can_id & 0xFFFFu;
    const std::uint32_t channel = can_id >> 16;
    if (identifier > kHighestIdentifier || channel > 255 || (!extended && channel != 0)) return {};
    return {static_cast<std::uint16_t>(identifier), static_cast<std::uint8_t>(channel), true};
}

void set_message_id(CanFrame& frame, std::uint16_t identifier, std::uint8_t channel) noexcept {
    frame.extended = channel != 0;
    frame.id = identifier + (static_cast<std::uint32_t>(channel) << 16);
}

MessageHeader read_header(const CanFrame& frame) noexcept { return {frame.data[0], frame.data[1], frame.data[2], frame.data[3]}; }

void write_header(CanFrame& frame, const MessageHeader& header) noexcept {
    frame.data[0] = header.node;
    frame.data[1] = header.data_type;
    frame.data[2] = header.service_code;
    frame.data[3] = header.message_code;
}

}  // namespace tedavis::bus
