/// The four header bytes of a CANaerospace message and its identifier (CANaerospace 1.7, sections 3.1 and 7.1).
#pragma once

#include <cstdint>
#include <type_traits>

#include "bus/frame/can_frame.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMessageHeaderBytes = 4;

struct MessageHeader {
    std::uint8_t node = 0;          ///< transmitter of normal data; 0 addresses all nodes in a service request
    std::uint8_t data_type = 0;     ///< see data_type.hpp
    std::uint8_t service_code = 0;  ///< normal data: status of the value, 0 if unused
    std::uint8_t message_code = 0;  ///< normal data: counts the messages of one identifier, wraps 255 -> 0
};
static_assert(std::is_trivially_copyable_v<MessageHeader>);

/// Returns how many messages `code` is after `before`, -128 .. 127, modulo 256.
[[nodiscard]] constexpr int code_step(std::uint8_t code, std::uint8_t before) noexcept {
    const int step = static_cast<std::uint8_t>(code - before);
    return step < 128 ? step : step - 256;
}

/// Identifier and redundancy channel: a 29-bit identifier is base + 65536 * channel, an 11-bit one is channel 0.
struct MessageId {
    std::uint16_t identifier = 0;  ///< 0..2031
    std::uint8_t channel = 0;
    bool valid = false;  ///< false: identifier above 2031, bits 11..15 set, or a channel above 255
};

[[nodiscard]] MessageId message_id(std::uint32_t can_id, bool extended) noexcept;
/// Sets the frame's identifier: 11 bits for channel 0, 29 bits for the others.
void set_message_id(CanFrame& frame, std::uint16_t identifier, std::uint8_t channel) noexcept;

/// The frame must hold at least four bytes.
[[nodiscard]] MessageHeader read_header(const CanFrame& frame) noexcept;
void write_header(CanFrame& frame, const MessageHeader& header) noexcept;

}  // namespace tedavis::bus
