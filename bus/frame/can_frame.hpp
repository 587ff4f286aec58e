/// A CAN or CAN FD frame as a value, with the instant it was received. The same value comes from a socket and from a log.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::bus {

enum class FrameKind : std::uint8_t { data, remote, error, fd };

struct CanFrame {
    base::Time time;        ///< receive stamp of kernel or log
    std::uint32_t id = 0;   ///< 11 or 29 bits; for an error frame its class bits
    bool extended = false;  ///< 29-bit identifier
    FrameKind kind = FrameKind::data;
    std::uint8_t fd_flags = 0;  ///< 1 BRS, 2 ESI, 4 FDF
    std::uint8_t raw_dlc = 0;   ///< DLC 9..15 of a classic frame, else 0
    std::uint8_t length = 0;    ///< valid bytes of data; for a remote frame the requested length
    std::uint8_t channel = 0;   ///< index of the interface, in order of appearance
    bool transmitted = false;   ///< sent by the recording host (log suffix T)
    std::array<std::uint8_t, 64> data{};
};
static_assert(std::is_trivially_copyable_v<CanFrame>);

}  // namespace tedavis::bus
