/// From what a flight showed to the expectations of a script, few enough to be read.
///
/// What changes is expected within the margin before and after the change; what lasts is expected in every frame from the margin
/// after its first frame to the margin before its last one, and where it lasts from the start or to the end, to there. Phase,
/// source and design are expected together, from one change of them to the next. What changes within the margin after the start,
/// while the first messages arrive, is not expected to change.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/flight_test/recorded_facts.hpp"

namespace tedavis::host_sim {

struct RecordingRule {
    double margin_s = 0.5;
    double rate_hz = 0;             ///< frames a second
    std::size_t expectations = 60;  ///< at most
};

struct RecordedExpectation {
    WindowKind kind = WindowKind::at;
    double from_s = 0, to_s = 0;
    std::vector<RecordedFact> facts;  ///< all of them hold in one frame; at least one
    std::string words;                ///< what happens there
};

struct RecordedExpectations {
    std::vector<RecordedExpectation> list;  ///< in the order of time
    std::string left_out;                   ///< what the rule has no room for, in words; empty: nothing
};

/// Changes that are at most the margin apart, of different things, are one expectation; what lasts between the same changes is
/// another one. Where there are more than the rule allows, the least important and the shortest are left out.
[[nodiscard]] RecordedExpectations expectations_of(const FactTracks& tracks, const RecordingRule& rule);

/// What one frame shows, expected at a time of which it is the first frame.
[[nodiscard]] RecordedExpectation expectation_at(double at_s, const std::vector<RecordedFact>& facts);

}  // namespace tedavis::host_sim
