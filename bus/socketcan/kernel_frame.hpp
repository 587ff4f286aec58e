/// Converts between the kernel's CAN records and CanFrame. Only this module knows the layout of <linux/can.h>.
#pragma once

#include <cstddef>

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kKernelFrameBytes = 16;    // struct can_frame
inline constexpr std::size_t kKernelFdFrameBytes = 72;  // struct canfd_frame

/// `bytes` as read from a raw socket: 16 for a classic frame, 72 for CAN FD. Returns false for any other size and for a length
/// that the record cannot hold. Time and channel stay unchanged.
[[nodiscard]] bool frame_from_kernel(base::Span<const unsigned char> bytes, CanFrame& frame) noexcept;

/// Returns 16 or 72, or 0 when the frame cannot be sent (an error frame, an impossible length).
[[nodiscard]] std::size_t frame_to_kernel(const CanFrame& frame, base::Span<unsigned char> out) noexcept;

/// The state of the controller that an error frame reports.
enum class ControllerEvent : std::uint8_t { none, warning, bus_off, restarted, overflow };
[[nodiscard]] ControllerEvent controller_event(const CanFrame& error_frame) noexcept;

}  // namespace tedavis::bus
