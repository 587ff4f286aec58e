/// What prevents an interface from serving as the board's CAN bus, in one sentence with the remedy. The start, the run and
/// --probe say the same.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include <string_view>

#include "bus/socketcan/interface_list.hpp"
#include "render_core/base/error.hpp"

namespace tedavis::bus {

/// Empty where the interface of this name is a CAN interface that is up, with a controller that takes part in the bus; also
/// where the list could not be read. Else "CAN interface 'can0': ...".
[[nodiscard]] base::Error interface_fault(const InterfaceList& list, std::string_view name);

/// Returns "can, up, 1000000 bit/s, error-active, restart after 100 ms".
[[nodiscard]] base::FixedString<127> interface_text(const NetInterface& link);

}  // namespace tedavis::bus
