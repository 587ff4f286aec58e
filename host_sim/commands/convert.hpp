/// `tedavis convert FLIGHT -o X.log`: converts a recorded flight to a candump log of CANaerospace frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct ConvertOptions {
    std::string flight;             ///< IGC, GPX, ADS-B JSON or CSV, plain or gzip
    std::string output;             ///< the log; `<output>.json` lists the derived values
    std::string aircraft;           ///< identity or callsign; empty: the only one
    std::optional<double> qnh_hpa;  ///< 870..1085
    bool assume_geometric = false;
};

/// Returns the exit code; throws UserError.
int run_convert(const ConvertOptions& options, Console& console);

/// The same as a part of another command; its messages are also appended to `said`.
int run_convert(const ConvertOptions& options, Console& console, std::vector<std::string>& said);

}  // namespace tedavis::host_sim
