#include "host_sim/flight_test/judge_expectation.hpp"

#include <cstdio>

namespace tedavis::host_sim {
namespace {

constexpr double kSameTime_s = 1e-6;  // by which a frame may miss its time, as numbers are rounded

}  // namespace

bool ExpectationJudge::wants(double time_s) const {
    if (is_settled_ || time_s < expectation_.from_s - kSameTime_s) return false;
    return expectation_.kind == WindowKind::at || time_s <= expectation_.to_s + kSameTime_s;
}

bool ExpectationJudge::is_last(double time_s) const {
    return expectation_.kind == WindowKind::at || time_s + 1 / rate_hz_ > expectation_.to_s + kSameTime_s;
}

void ExpectationJudge::note_failure(const ObservedFrame& frame, const FrameCondition& condition, const Observation& observation) {
    result_.failed_s = frame.time_s;
    result_.key = condition.key;
    result_.expected = condition.expected;
    result_.found = observation.found;
    result_.reason = observation.reason;
}

bool ExpectationJudge::take(const ObservedFrame& frame) {
    const bool is_first = !has_frame_;
    has_frame_ = true;
    const bool holds = observe(frame);
    if (expectation_.kind == WindowKind::within) return take_of_reach(frame, holds, is_first);
    is_settled_ = !holds || is_last(frame.time_s);
    result_.holds = is_settled_ && holds;
    return is_settled_ && !holds;
}

bool ExpectationJudge::observe(const ObservedFrame& frame) {
    for (const FrameCondition& condition : expectation_.conditions) {
        const Observation observation = condition.observe(frame);
        if (observation.holds) continue;
        note_failure(frame, condition, observation);
        return false;
    }
    return true;
}

bool ExpectationJudge::take_of_reach(const ObservedFrame& frame, bool holds, bool is_first) {
    const bool has_left = !holds && result_.reached_s.has_value();
    const bool held_before = holds && is_first;
    if (holds && !held_before && !result_.reached_s) result_.reached_s = frame.time_s;
    if (held_before)
        note_failure(frame, {"after_s", "a frame in which it does not hold yet", {}},
                     {false, "already held at after_s", "the state before passes; say from_s and to_s, or an earlier after_s"});
    if (has_left) result_.reason += " (it was reached before, and did not stay)";
    const bool is_over = is_last(frame.time_s) || (result_.reached_s && !expectation_.stays);
    is_settled_ = held_before || has_left || is_over;
    result_.holds = is_settled_ && holds && !held_before;
    return is_settled_ && !result_.holds;
}

ExpectationResult ExpectationJudge::result() const {
    ExpectationResult result = result_;
    if (is_settled_) return result;
    result.holds = false;
    if (!result.key.empty()) return result;
    char expected[96];
    std::snprintf(expected, sizeof expected, "frames from %g s to %g s", expectation_.from_s, expectation_.to_s);
    result.failed_s = expectation_.from_s;
    result.key = "time";
    result.expected = expected;
    result.found = has_frame_ ? "only the first of them" : "none";
    result.reason = "the input ended, or no frame of the device lies there";
    return result;
}

}  // namespace tedavis::host_sim
