#include "host_sim/flight_test/judge_expectation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tedavis::host_sim {

std::string frame_time_text(double time_s) {
    constexpr double kMilliseconds = 1000;  // of a second
    char text[32];
    std::snprintf(text, sizeof text, "%.3f s", std::floor((time_s + kSameTime_s) * kMilliseconds) / kMilliseconds);
    return text;
}

ExpectationJudge::ExpectationJudge(const Expectation& expectation, const FrameTimes& times)
    : expectation_(expectation), times_(times) {
    for (const FrameCondition& condition : expectation.conditions)
        observers_.push_back(condition.begin ? condition.begin(expectation.kind) : condition.observe);
}

/// An expectation that must be reached also looks at the last frame up to from_s. On the desk that frame is known by its time; a
/// running display has no fixed rate, so there each frame before from_s is looked at.
bool ExpectationJudge::wants(double time_s) const {
    if (is_settled_ || time_s > last_s() + kSameTime_s) return false;
    if (expectation_.kind != WindowKind::within) return time_s >= expectation_.from_s - kSameTime_s;
    return !times_.rate_hz || time_s + 1 / *times_.rate_hz > expectation_.from_s + kSameTime_s;
}

/// The latest time of a frame that counts.
double ExpectationJudge::last_s() const {
    if (expectation_.kind != WindowKind::at) return expectation_.to_s;
    return times_.rate_hz ? std::numeric_limits<double>::infinity() : expectation_.from_s + kLatestFrame_s;
}

/// A running display has no fixed rate, so its last frame in the window is not known in advance.
bool ExpectationJudge::is_last(double time_s) const {
    if (expectation_.kind == WindowKind::at) return true;
    return times_.rate_hz && time_s + 1 / *times_.rate_hz > expectation_.to_s + kSameTime_s;
}

void ExpectationJudge::record_failure(const ObservedFrame& frame, const FrameCondition& condition,
                                      const Observation& observation) {
    result_.failed_s = frame.time_s;
    result_.key = condition.key;
    result_.expected = condition.expected;
    result_.found = observation.found;
    result_.reason = observation.reason;
}

bool ExpectationJudge::take(const ObservedFrame& frame) {
    if (expectation_.kind == WindowKind::within)
        return frame.time_s <= expectation_.from_s + kSameTime_s ? take_before(frame) : take_of_reach(frame);
    has_frame_ = true;
    const bool holds = observe(frame);
    is_settled_ = !holds || is_last(frame.time_s);
    result_.holds = is_settled_ && holds;
    return is_settled_ && !holds;
}

bool ExpectationJudge::observe(const ObservedFrame& frame) {
    for (std::size_t n = 0; n < observers_.size(); ++n) {
        const Observation observation = observers_[n](frame);
        if (observation.holds) continue;
        record_failure(frame, expectation_.conditions[n], observation);
        return false;
    }
    return true;
}

/// What is shown at from_s is what the last frame up to then shows.
bool ExpectationJudge::take_before(const ObservedFrame& frame) {
    held_at_s_ = observe(frame) ? std::optional<double>(frame.time_s) : std::nullopt;
    const bool is_at_from = frame.time_s >= expectation_.from_s - kSameTime_s;
    return held_at_s_ && is_at_from && fail_as_held_before(*held_at_s_);
}

bool ExpectationJudge::fail_as_held_before(double time_s) {
    ObservedFrame frame;
    frame.time_s = time_s;
    char expected[96];
    std::snprintf(expected, sizeof expected, "what begins after %g s, and by %g s", expectation_.from_s, expectation_.to_s);
    record_failure(
        frame, {"after_s", expected, {}},
        {false, "it holds already at " + frame_time_text(time_s), "say an earlier after_s, or from_s and to_s for what lasts"});
    is_settled_ = true;
    return true;
}

bool ExpectationJudge::take_of_reach(const ObservedFrame& frame) {
    if (held_at_s_) return fail_as_held_before(*held_at_s_);
    has_frame_ = true;
    const bool holds = observe(frame);
    const bool has_left = !holds && result_.reached_s.has_value();
    if (holds && !result_.reached_s) result_.reached_s = frame.time_s;
    if (has_left) result_.reason += " (it was reached before, and did not stay)";
    const bool is_over = is_last(frame.time_s) || (result_.reached_s && !expectation_.stays);
    is_settled_ = has_left || is_over;
    result_.holds = is_settled_ && holds;
    return is_settled_ && !result_.holds;
}

bool ExpectationJudge::pass(double time_s) {
    if (is_settled_) return false;
    if (fail_as_frozen(time_s)) return true;
    passed_s_ = time_s;
    if (time_s <= last_s() + kSameTime_s) return false;
    is_settled_ = true;
    if (held_at_s_) return fail_as_held_before(*held_at_s_);
    if (!has_frame_) record_no_frame();
    result_.holds = has_frame_ && (expectation_.kind == WindowKind::during || result_.reached_s.has_value());
    return !result_.holds;
}

/// Between two frames the screen shows what nobody has looked at.
bool ExpectationJudge::fail_as_frozen(double time_s) {
    const bool is_during = expectation_.kind == WindowKind::during, is_staying = expectation_.stays && result_.reached_s;
    if (times_.rate_hz || !(is_during || is_staying)) return false;
    if (!has_frame_ && time_s > last_s()) return false;  // there is no frame at all
    const double begin_s = std::max(passed_s_, is_during ? expectation_.from_s : *result_.reached_s);
    const double end_s = std::min(time_s, expectation_.to_s);
    if (end_s - begin_s <= kLatestFrame_s + kSameTime_s) return false;
    char expected[96], found[96];
    std::snprintf(expected, sizeof expected, "a frame at least every %g s", kLatestFrame_s);
    std::snprintf(found, sizeof found, "none from %.2f s to %.2f s", begin_s, end_s);
    ObservedFrame frame;
    frame.time_s = begin_s;
    record_failure(frame, {"time", expected, {}}, {false, found, "the display stood still; see what its frames wait for"});
    is_settled_ = true;
    return true;
}

void ExpectationJudge::record_no_frame() {
    char expected[96];
    std::snprintf(expected, sizeof expected, "frames from %g s to %g s", expectation_.from_s, expectation_.to_s);
    result_.failed_s = expectation_.from_s;
    result_.key = "time";
    result_.expected = expected;
    result_.found = has_frame_ ? "only the first of them" : "none";
    result_.reason = times_.rate_hz ? "the input ended before them"
                                    : "the display had none ready in this time; give it more, or make its frames faster";
}

ExpectationResult ExpectationJudge::result() const {
    if (is_settled_) return result_;
    ExpectationJudge ended = *this;
    ended.result_.holds = false;
    if (ended.result_.key.empty() || !has_frame_) ended.record_no_frame();
    return ended.result_;
}

}  // namespace tedavis::host_sim
