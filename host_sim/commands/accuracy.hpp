/// `tedavis accuracy`: measures errors and times of all levels of the knobs on this machine.
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
    std::string costs;                 ///< a calibration file, whose quality levels are added to the report; empty: none
    std::optional<double> budget_ms;   ///< time for which the most accurate levels are printed; nothing: none
    bool is_control_only = false;      ///< measures the negative control alone
    std::vector<std::string> compare;  ///< accuracy.json of earlier runs
    double slower_percent = 25, less_accurate_percent = 10;  ///< beyond these a comparison fails
    std::string target_error;  ///< error such as "0.5 px", for which the quickest levels are printed; empty: none
};

/// Writes accuracy.json, accuracy.csv, report.html with its pictures, and the shipped terrain's database to the folder after each
/// knob, so that an interrupted run continues where it stopped. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_accuracy(const AccuracyOptions& options, Console& console);

struct TargetError {
    double value = 0;
    std::string unit;
};
/// A number above 0 and its unit, with or without a space between them. Throws UserError.
[[nodiscard]] TargetError target_from(const std::string& text);

}  // namespace tedavis::host_sim
