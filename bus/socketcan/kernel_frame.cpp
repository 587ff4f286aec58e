#include "bus/socketcan/kernel_frame.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#include <cstring>

#include "bus/frame/fd_length.hpp"

namespace tedavis::bus {
namespace {

static_assert(sizeof(can_frame) == kKernelFrameBytes && sizeof(canfd_frame) == kKernelFdFrameBytes);
constexpr std::uint8_t kFdFlagMask = 0x0F;
// `len8_dlc` of newer kernels: the byte before the data, padding in older headers.
constexpr std::size_t kRawLengthOffset = 7;

void take_identifier(std::uint32_t can_id, CanFrame& frame) {
    const bool error = (can_id & CAN_ERR_FLAG) != 0;
    frame.extended = !error && (can_id & CAN_EFF_FLAG) != 0;
    frame.id = can_id & (error ? CAN_ERR_MASK : frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.kind = error ? FrameKind::error : (can_id & CAN_RTR_FLAG) != 0 ? FrameKind::remote : FrameKind::data;
}

}  // namespace

bool frame_from_kernel(base::Span<const unsigned char> bytes, CanFrame& frame) noexcept {
    const bool fd = bytes.size() == kKernelFdFrameBytes;
    if (!fd && bytes.size() != kKernelFrameBytes) return false;
    canfd_frame record{};
    std::memcpy(&record, bytes.data(), bytes.size());
    if (fd ? !is_fd_length(record.len) : record.len > CAN_MAX_DLEN) return false;
    const base::Time time = frame.time;
    const std::uint8_t channel = frame.channel;
    frame = CanFrame();
    frame.time = time;
    frame.channel = channel;
    take_identifier(record.can_id, frame);
    frame.length = record.len;
    if (fd) {
        if (frame.kind != FrameKind::data) return false;
        frame.kind = FrameKind::fd;
        frame.fd_flags = record.flags & kFdFlagMask;
    } else if (const unsigned char code = bytes[kRawLengthOffset]; frame.length == CAN_MAX_DLEN && code > 8 && code < 16) {
        frame.raw_dlc = code;
    }
    if (frame.kind != FrameKind::remote) std::memcpy(frame.data.data(), record.data, record.len);
    return true;
}

std::size_t frame_to_kernel(const CanFrame& frame, base::Span<unsigned char> out) noexcept {
    const bool fd = frame.kind == FrameKind::fd;
    const bool length_exists = fd ? is_fd_length(frame.length) : frame.length <= CAN_MAX_DLEN;
    const bool identifier_exists = frame.id <= (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    const std::size_t size = fd ? kKernelFdFrameBytes : kKernelFrameBytes;
    if (frame.kind == FrameKind::error || !length_exists || !identifier_exists || out.size() < size) return 0;
    canfd_frame record{};
    record.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0) | (frame.kind == FrameKind::remote ? CAN_RTR_FLAG : 0);
    record.len = frame.length;
    record.flags = fd ? frame.fd_flags : 0;
    if (frame.kind != FrameKind::remote) std::memcpy(record.data, frame.data.data(), frame.length);
    std::memcpy(out.data(), &record, size);
    if (!fd && frame.raw_dlc > 8 && frame.length == CAN_MAX_DLEN) out[kRawLengthOffset] = frame.raw_dlc;
    return size;
}

ControllerEvent controller_event(const CanFrame& error_frame) noexcept {
    if ((error_frame.id & CAN_ERR_BUSOFF) != 0) return ControllerEvent::bus_off;
    if ((error_frame.id & CAN_ERR_RESTARTED) != 0) return ControllerEvent::restarted;
    if ((error_frame.id & CAN_ERR_CRTL) == 0) return ControllerEvent::none;
    const std::uint8_t detail = error_frame.data[1];
    if ((detail & CAN_ERR_CRTL_RX_OVERFLOW) != 0) return ControllerEvent::overflow;
    constexpr std::uint8_t kBad =
        CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING | CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;
    return (detail & kBad) != 0 ? ControllerEvent::warning : ControllerEvent::none;
}

}  // namespace tedavis::bus
