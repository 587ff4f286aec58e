/// Port: opens the CAN socket. The product opens the kernel's raw CAN socket, tests a socket pair.
#pragma once

#include <cstdint>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::bus {

/// Passes frames with (received identifier & mask) == (identifier & mask); bit 31 marks 29-bit identifiers, bit 30 remote
/// frames, as in the kernel.
struct CanFilter {
    std::uint32_t identifier = 0;
    std::uint32_t mask = 0;
};

struct SocketCanSettings {
    base::FixedString<15> interface_name;       ///< "can0"
    base::FixedVector<CanFilter, 512> filters;  ///< empty: all frames pass; 512 is the kernel's limit
    bool can_fd = false;
    std::uint32_t receive_buffer_bytes = 1u << 20;
    base::Duration reopen_interval = base::Duration::seconds(1);  ///< at most one attempt in this time
};

/// Adds the two filters that pass one CANaerospace identifier on all redundancy channels: the exact 11-bit identifier, and the
/// 29-bit ones whose low 16 bits equal it. Returns false when they do not fit.
[[nodiscard]] bool add_identifier_filters(SocketCanSettings& settings, std::uint16_t identifier);

using SocketFaultText = base::FixedString<511>;

struct OpenedSocket {
    int descriptor = -1;     ///< non-blocking; -1 when it could not be opened
    SocketFaultText reason;  ///< where it could not be opened: what is wrong and what to do
};

class CanSocketPort {
public:
    virtual ~CanSocketPort() = default;
    /// Opens the socket; never blocks. The caller owns and closes the descriptor.
    [[nodiscard]] virtual OpenedSocket open(const SocketCanSettings& settings) = 0;
    /// One sentence why nothing comes from the interface, and what to do; empty where the system shows no fault. Asks
    /// the system, so it belongs to a message, not to every attempt. Never allocates.
    [[nodiscard]] virtual SocketFaultText explain(const SocketCanSettings& /*settings*/) { return {}; }
};

}  // namespace tedavis::bus
