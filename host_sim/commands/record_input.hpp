/// The input of `tedavis record`: a candump log, the folder of a run, the folder of a generated flight, or a shipped scenario.
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
    std::string design, device;  ///< empty: those of the run, else the defaults of a script
    std::string aircraft;        ///< empty: that of the run, else none
    std::string terrain, scene;  ///< likewise; a name without a path is built first, as in a script
    std::string output;          ///< script to write
    std::optional<double> from_s, to_s;
    std::vector<double> at_s;  ///< expects single frames at these times instead of all between from_s and to_s
    double margin_s = 0.5;
    bool yes = false;                           ///< replaces a script that is there already
    std::string target, board, interface_name;  ///< instead of `input`: a running display, as in VerifyOptions
    double for_s = 60;                          ///< duration of the recording of a running display
};

/// Returns the test that plays the input, without expectations. Names and paths come from the options or, where these state none,
/// from the input's folder. Throws UserError where there is no such input, or files of the run are missing.
[[nodiscard]] FlightTest recorded_input(const RecordOptions& options);

/// Seconds since the input's first frame; nothing: its own end.
struct RecordedSpan {
    std::optional<double> from_s, to_s;
};

/// Returns the span that the options state; where they state neither end, that of the frames in the folder of a replay. Throws
/// UserError.
[[nodiscard]] RecordedSpan recorded_span(const RecordOptions& options);

}  // namespace tedavis::host_sim
