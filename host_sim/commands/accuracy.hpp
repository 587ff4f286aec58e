/// `tedavis accuracy`: what every knob's accuracy costs in time on this machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/commands/trace.hpp"

namespace tedavis::host_sim {

struct AccuracyOptions {
    std::string output;  ///< folder
    /// .tdb; empty: built from the shipped raster. One for all flights, or one for each.
    std::vector<std::string> terrains;
    std::vector<std::string> flights;   ///< CAN logs; the knobs fly the first one; empty: the shipped flight
    std::vector<std::string> switches;  ///< switch logs, of the flights in their order; the last flights may have none
    FlownDisplay display;
    bool is_quick = false;             ///< fewer samples and rounds
    std::vector<std::string> knobs;    ///< empty: all
    std::string costs;                 ///< a calibration file: adds what the governor may choose by it; empty: nothing
    std::optional<double> budget_ms;   ///< asks for the most accurate levels within it
    bool is_control_only = false;      ///< measures the negative control alone
    std::vector<std::string> compare;  ///< accuracy.json of earlier runs
    double slower_percent = 25, less_accurate_percent = 10;  ///< beyond these a comparison fails
    std::string target_error;  ///< such as "0.5 px": asks for the quickest levels that keep to it; empty: nothing
};

/// Leaves accuracy.json, accuracy.csv, report.html with its pictures, and the shipped terrain's database in the folder, after
/// each knob, so that a run that was stopped goes on where it was. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_accuracy(const AccuracyOptions& options, Console& console);

struct TargetError {
    double value = 0;
    std::string unit;
};
/// A number above 0 and its unit, with or without a space between them. Throws UserError.
[[nodiscard]] TargetError target_from(const std::string& text);

}  // namespace tedavis::host_sim
