/// `tedavis bus encode signal=value… [--at T] [--interface can0]`: frames of the bus as candump lines.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct BusEncodeOptions {
    std::vector<std::string> values;  ///< "indicated_airspeed_kt=90", "phase=approach.final", "phase_origin=fms"
    std::string bus = "canaerospace";
    std::string interface_name = "can0";
    double at_s = 0;    ///< stamp of the first frame
    unsigned code = 0;  ///< 0..255: message code of the first frame of each identifier; its next frames count on from it
};

/// Prints the frames in the order of the values. If some values cannot be sent, prints no frames but a message for each of these
/// values, and returns kFaultyInputExitCode. Throws UserError where the bus file cannot be used.
[[nodiscard]] int run_bus_encode(const BusEncodeOptions& options, Console& console);

}  // namespace tedavis::host_sim
