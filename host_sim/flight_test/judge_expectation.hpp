/// Judges expectations frame by frame, in the order of time.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// By which a frame may miss its time, as numbers are rounded, s.
inline constexpr double kSameTime_s = 1e-6;

/// What became of an expectation.
struct ExpectationResult {
    bool holds = false;
    std::optional<double> reached_s;  ///< of one that must be reached, when it was
    // Of one that does not hold:
    double failed_s = 0;  ///< its first failing instant
    std::string key, expected, found, reason;
    // On a board:
    bool is_judged = true;       ///< false: nothing that it asks for can be judged; it neither holds nor fails
    std::size_t not_judged = 0;  ///< of its conditions
};

/// When frames come: of a device that keeps its rate, or whenever a running display has one ready.
struct FrameTimes {
    std::optional<double> rate_hz;  ///< nothing: they come when they come, and their times are told by pass()
};

class ExpectationJudge {
public:
    /// The latest frame of a running display that still shows what there was "at" a time, and the longest time without a frame
    /// where something must hold in every one.
    static constexpr double kLatestFrame_s = 0.5;

    /// The expectation must outlive the judge.
    ExpectationJudge(const Expectation& expectation, const FrameTimes& times);

    /// Whether the frame at this time matters to what is still open.
    [[nodiscard]] bool wants(double time_s) const;
    /// Takes a frame that it wants. True where the expectation fails with this frame.
    bool take(const ObservedFrame& frame);
    /// No frame before this time is still to come: of a running display to be called with the time of each frame, before take().
    /// True where the expectation fails by that.
    bool pass(double time_s);
    [[nodiscard]] bool is_settled() const { return is_settled_; }
    /// After the last frame.
    [[nodiscard]] ExpectationResult result() const;

private:
    [[nodiscard]] bool is_last(double time_s) const;
    [[nodiscard]] double last_s() const;
    /// Whether all conditions hold in it.
    bool observe(const ObservedFrame& frame);
    bool take_before(const ObservedFrame& frame);
    bool take_of_reach(const ObservedFrame& frame);
    bool fail_as_held_before(double time_s);
    bool fail_as_frozen(double time_s);
    void record_no_frame();
    void record_failure(const ObservedFrame& frame, const FrameCondition& condition, const Observation& observation);

    const Expectation& expectation_;
    FrameTimes times_;
    std::vector<FrameObserver> observers_;  ///< one per condition
    bool is_settled_ = false;
    bool has_frame_ = false;  ///< of its time
    double passed_s_ = -std::numeric_limits<double>::infinity();
    std::optional<double> held_at_s_;  ///< of one that must be reached: the last frame up to from_s, where it holds in it
    ExpectationResult result_;
};

}  // namespace tedavis::host_sim
