/// Judges expectations frame by frame, in the order of time.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/flight_test.hpp"

namespace tedavis::host_sim {

/// Tolerance for the rounding of a frame's time, s.
inline constexpr double kSameTime_s = 1e-6;

/// "4.066 s" of the frame at 122/30 s: milliseconds, rounded down, so that `at_s = 4.066` is this frame.
[[nodiscard]] std::string frame_time_text(double time_s);

/// The result of an expectation.
struct ExpectationResult {
    bool holds = false;
    std::optional<double> reached_s;  ///< of WindowKind::within: the time of the first frame in which it held
    // Of an expectation that does not hold:
    double failed_s = 0;  ///< time of its first failing frame
    std::string key, expected, found, reason;
    // On a board:
    bool is_judged = true;       ///< false: none of its conditions can be judged; it neither holds nor fails
    std::size_t not_judged = 0;  ///< of its conditions
};

/// The times of frames: at a fixed rate, or whenever a running display has one ready.
struct FrameTimes {
    std::optional<double> rate_hz;  ///< nothing: no fixed rate; pass() is called with the time of each frame
};

class ExpectationJudge {
public:
    /// Longest delay of the frame that is judged for WindowKind::at, and longest time without a frame in a window in which every
    /// frame must hold; for a running display.
    static constexpr double kLatestFrame_s = 0.5;

    /// The expectation must outlive the judge.
    ExpectationJudge(const Expectation& expectation, const FrameTimes& times);

    /// Whether the frame at this time can change the result.
    [[nodiscard]] bool wants(double time_s) const;
    /// Judges a frame for which wants() is true; frames are given in order of time. Returns true if the expectation fails with
    /// this frame.
    bool take(const ObservedFrame& frame);
    /// States that no frame before this time will follow. For a running display, call it with the time of each frame before
    /// take(). Returns true if the expectation fails because a frame is missing.
    bool pass(double time_s);
    [[nodiscard]] bool is_settled() const { return is_settled_; }
    /// The result; to be called after the last frame.
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
    bool has_frame_ = false;  ///< a frame of the window was judged
    double passed_s_ = -std::numeric_limits<double>::infinity();
    std::optional<double> held_at_s_;  ///< of WindowKind::within: time of the last frame up to from_s, if it held in that frame
    ExpectationResult result_;
};

}  // namespace tedavis::host_sim
