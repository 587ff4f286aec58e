/// The network interfaces of this machine, as far as a CAN bus needs them: what the kernel says over rtnetlink.
///
/// Thread  any. Memory  none. Failure  a list that could not be read says so.
#pragma once

#include <cstdint>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

/// What a CAN controller says of its errors.
enum class ControllerState : std::uint8_t { unknown, active, warning, passive, bus_off, stopped, sleeping };

struct NetInterface {
    base::FixedString<15> name;
    base::FixedString<15> kind;  ///< "can": a controller; "vcan", "vxcan": no wire; empty: the kernel names none
    bool is_can = false;
    bool is_up = false;
    bool has_carrier = false;
    std::uint32_t bit_rate_hz = 0;  ///< of a controller; 0: none is set, or it is not known
    bool has_listed_rates = false;  ///< the controller has some rates only, as a serial adapter has
    std::uint32_t restart_ms = 0;   ///< 0: a controller that is bus-off stays so
    ControllerState state = ControllerState::unknown;
};

struct InterfaceList {
    base::FixedVector<NetInterface, 64> interfaces;  ///< those that do not fit are counted only
    bool is_read = false;                            ///< false: the kernel did not answer
    bool has_can = true;                             ///< false: the kernel has no CAN sockets
};

enum class LinkMessages : std::uint8_t { go_on, ended, damaged };

/// Adds what one answer of the kernel to RTM_GETLINK holds, message by message. Parts that are cut or contradict themselves are
/// left out; `damaged` where no further message can be found.
[[nodiscard]] LinkMessages add_links(base::Span<const unsigned char> answer, InterfaceList& list);

/// Asks the kernel, and waits for each part of its answer for 20 ms at most.
void list_interfaces(InterfaceList& list);

}  // namespace tedavis::bus
