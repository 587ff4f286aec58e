/// Derives the expectations of a script from the recorded facts of a flight, few enough to be read.
///
/// A change becomes an expectation of the new value in a window from the margin before it to the margin after it. A span becomes
/// an expectation in every frame from the margin after its first frame to the margin before its last one; at the start and at the
/// end of the recording no margin is left. Phase, source and design are expected together, from one change of them to the next.
/// Changes within the margin after the start, while the first messages arrive, give no expectation.
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
    std::string words;                ///< description of the change or span, for a comment
};

struct RecordedExpectations {
    std::vector<RecordedExpectation> list;  ///< in the order of time
    std::string left_out;                   ///< description of the expectations beyond the rule's number; empty: there are none
};

/// Changes of different facts that are at most the margin apart are joined to one expectation; so are spans between the same
/// changes. Above the rule's number, the least important and the shortest are left out.
[[nodiscard]] RecordedExpectations expectations_of(const FactTracks& tracks, const RecordingRule& rule);

/// Expects the facts of one frame (WindowKind::at) at a time at or before it, and after the frame before.
[[nodiscard]] RecordedExpectation expectation_at(double at_s, const std::vector<RecordedFact>& facts);

}  // namespace tedavis::host_sim
