/// Judges expectations frame by frame, in the order of time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// What became of an expectation.
struct ExpectationResult {
    bool holds = false;
    std::optional<double> reached_s;  ///< of one that must be reached, when it was
    // Of one that does not hold:
    double failed_s = 0;  ///< its first failing instant
    std::string key, expected, found, reason;
};

class ExpectationJudge {
public:
    /// The expectation must outlive the judge. `rate_hz`: frames of the device a second.
    ExpectationJudge(const Expectation& expectation, double rate_hz) : expectation_(expectation), rate_hz_(rate_hz) {}

    /// Whether the frame at this time matters to what is still open.
    [[nodiscard]] bool wants(double time_s) const;
    /// Takes a frame that it wants. True where the expectation fails with this frame.
    bool take(const ObservedFrame& frame);
    /// After the last frame.
    [[nodiscard]] ExpectationResult result() const;

private:
    [[nodiscard]] bool is_last(double time_s) const;
    /// Whether all conditions hold in it.
    bool observe(const ObservedFrame& frame);
    bool take_of_reach(const ObservedFrame& frame, bool holds, bool is_first);
    void note_failure(const ObservedFrame& frame, const FrameCondition& condition, const Observation& observation);

    const Expectation& expectation_;
    double rate_hz_;
    bool is_settled_ = false, has_frame_ = false;
    ExpectationResult result_;
};

}  // namespace tedavis::host_sim
