/// What `tedavis record` plays: a candump log, the folder of a run, the folder of a generated flight, or a shipped scenario.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

struct RecordOptions {
    std::string input;           ///< a file, a folder, or the name of a scenario
    std::string switches;        ///< switch log; empty: none, or what the folder has
    std::string switch_config;   ///< empty: one_hot
    std::string bus;             ///< empty: canaerospace
    std::string design, device;  ///< empty: those of the run, else what a script without them has
    std::string aircraft;        ///< empty: of the run, else none
    std::string terrain, scene;  ///< the same; names stand for what is built, as in a script
    std::string output;          ///< script to write
    std::optional<double> from_s, to_s;
    std::vector<double> at_s;  ///< instead of all frames between these two
    double margin_s = 0.5;
    bool yes = false;                           ///< replaces a script that is there already
    std::string target, board, interface_name;  ///< instead of `input` a running display, as VerifyOptions has it
    double for_s = 60;                          ///< to listen to it
};

/// The test that plays it, without expectations: names and paths are those of the options, which come first, and of the folder.
/// Throws UserError where there is no such input, or a run's files are gone.
[[nodiscard]] FlightTest recorded_input(const RecordOptions& options);

/// Seconds since the input's first frame; nothing: its own end.
struct RecordedSpan {
    std::optional<double> from_s, to_s;
};

/// As the options say; where they say neither end, that of the frames that a replay wrote to its folder. Throws UserError.
[[nodiscard]] RecordedSpan recorded_span(const RecordOptions& options);

}  // namespace tedavis::host_sim
