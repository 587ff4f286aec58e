/// `tedavis sweep -o DIR`: draws a place from viewpoints round it and measures each picture.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/sweep/draw_sweep.hpp"

namespace tedavis::host_sim {

struct SweepOptions {
    std::optional<SweptPlace> place;  ///< nothing: the middle of the terrain
    double radius_m = 250;
    SweepRings rings;
    std::optional<base::Time> time;  ///< time for the age of data; nothing: data are shown at their own time
    std::string phase;               ///< "takeoff.first_climb", as if a switch stated it; empty: none is stated
    PictureOptions picture;          ///< without terrain: the shipped one, and the data of the shipped scenario
    bool layers = false;
    std::string output;  ///< folder
};

/// Writes the pictures, sweep.json and report.html. Returns the exit code, 2 also for a sweep whose terrain failed,
/// kInterruptedExitCode with a valid result of the views so far; throws UserError and Interrupted.
[[nodiscard]] int run_sweep(const SweepOptions& options, Console& console);

}  // namespace tedavis::host_sim
