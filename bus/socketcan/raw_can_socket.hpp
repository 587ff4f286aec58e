/// The kernel's PF_CAN raw socket.
#pragma once

#include "bus/socketcan/can_socket_port.hpp"

namespace tedavis::bus {

/// Binds to the interface with the settings' filters, all error classes, kernel time stamps, the overflow counter and the
/// requested receive buffer. The bit rate and `restart-ms` are set by the system (`ip link set can0 ...`).
class RawCanSocket final : public CanSocketPort {
public:
    [[nodiscard]] OpenedSocket open(const SocketCanSettings& settings) override;
    [[nodiscard]] SocketFaultText explain(const SocketCanSettings& settings) override;
};

}  // namespace tedavis::bus
