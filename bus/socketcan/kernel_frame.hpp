/// The kernel's CAN records as frames, and back. The layout of <linux/can.h> is known only behind this face.
#pragma once

#include <cstddef>

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kKernelFrameBytes = 16;    // struct can_frame
inline constexpr std::size_t kKernelFdFrameBytes = 72;  // struct canfd_frame

/// `bytes` as read from a raw socket: 16 for a classic frame, 72 for CAN FD. False for any other size or a length that
/// the record cannot hold. Leaves time and channel alone.
[[nodiscard]] bool frame_from_kernel(base::Span<const unsigned char> bytes, CanFrame& frame) noexcept;

/// Returns 16 or 72, or 0 when the frame is none that can be sent (an error frame, a length that does not exist).
[[nodiscard]] std::size_t frame_to_kernel(const CanFrame& frame, base::Span<unsigned char> out) noexcept;

/// What an error frame says about the controller.
enum class ControllerEvent : std::uint8_t { none, warning, bus_off, restarted, overflow };
[[nodiscard]] ControllerEvent controller_event(const CanFrame& error_frame) noexcept;

}  // namespace tedavis::bus
