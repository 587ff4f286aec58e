#include "host_sim/flight_test/judge_expectation.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_judge_expectation {
namespace {

constexpr double kRate_hz = 10;

Expectation of_latency(WindowKind kind, double from_s, double to_s) {
    Expectation expectation;
    expectation.kind = kind;
    expectation.from_s = from_s;
    expectation.to_s = to_s;
    expectation.conditions.push_back(
        {"latency", "at most 1", [](const ObservedFrame& frame) {
             return Observation{frame.latency_frames <= 1, std::to_string(frame.latency_frames), "why"};
         }});
    return expectation;
}

/// Flies 0 to 10 s; the condition holds from `good_from_s` up to, but not at, `good_to_s`.
ExpectationResult judged(const Expectation& expectation, double good_from_s, double good_to_s) {
    ExpectationJudge judge(expectation, kRate_hz);
    for (int n = 0; n <= 100; ++n) {
        ObservedFrame frame;
        frame.time_s = n / kRate_hz;
        frame.latency_frames = frame.time_s >= good_from_s - 1e-9 && frame.time_s < good_to_s - 1e-9 ? 0 : 5;
        if (judge.wants(frame.time_s)) static_cast<void>(judge.take(frame));
    }
    return judge.result();
}

TEST(JudgeExpectation, AtLooksAtOneFrame) {
    const Expectation at = of_latency(WindowKind::at, 5, 5);
    EXPECT_TRUE(judged(at, 5, 5.1).holds);
    const ExpectationResult failed = judged(at, 5.1, 6);
    EXPECT_FALSE(failed.holds);
    EXPECT_DOUBLE_EQ(failed.failed_s, 5);
    EXPECT_EQ(failed.expected, "at most 1");
    EXPECT_EQ(failed.reason, "why");
    EXPECT_FALSE(judged(of_latency(WindowKind::at, 4.95, 4.95), 4, 5).holds) << "the frame after the time, at 5 s";
}

TEST(JudgeExpectation, DuringFailsAtTheFirstFrame) {
    const Expectation during = of_latency(WindowKind::during, 2, 4);
    EXPECT_TRUE(judged(during, 2, 4.1).holds);
    EXPECT_DOUBLE_EQ(judged(during, 2, 3).failed_s, 3);
    EXPECT_DOUBLE_EQ(judged(during, 2, 4).failed_s, 4) << "both ends belong to it";
}

TEST(JudgeExpectation, WithinSaysWhenItWasReached) {
    const Expectation within = of_latency(WindowKind::within, 2, 4);
    EXPECT_DOUBLE_EQ(*judged(within, 3, 3.1).reached_s, 3);
    const ExpectationResult late = judged(within, 4.1, 9);
    EXPECT_FALSE(late.holds);
    EXPECT_FALSE(late.reached_s);
    EXPECT_DOUBLE_EQ(late.failed_s, 4) << "the last frame in which it could have been reached";
}

/// The state from before the event is not its effect.
TEST(JudgeExpectation, WhatAlreadyHoldsIsNotReached) {
    const ExpectationResult before = judged(of_latency(WindowKind::within, 2, 4), 0, 10);
    EXPECT_FALSE(before.holds);
    EXPECT_FALSE(before.reached_s);
    EXPECT_DOUBLE_EQ(before.failed_s, 2);
    EXPECT_EQ(before.found, "already held at after_s");
    EXPECT_TRUE(judged(of_latency(WindowKind::within, 2, 4), 2.1, 10).holds) << "not in its first frame";
}

TEST(JudgeExpectation, WhatStaysHoldsToTheEndOfItsTime) {
    Expectation stays = of_latency(WindowKind::within, 2, 4);
    EXPECT_TRUE(judged(stays, 3, 3.1).holds) << "one frame is enough without it";
    stays.stays = true;
    EXPECT_TRUE(judged(stays, 3, 4.1).holds);
    EXPECT_DOUBLE_EQ(*judged(stays, 3, 4.1).reached_s, 3);
    const ExpectationResult flickers = judged(stays, 3, 3.1);
    EXPECT_FALSE(flickers.holds);
    EXPECT_DOUBLE_EQ(flickers.failed_s, 3.1);
    EXPECT_EQ(flickers.reason, "why (it was reached before, and did not stay)");
    EXPECT_FALSE(judged(stays, 1, 10).holds) << "before its time";
    EXPECT_FALSE(judged(stays, 5, 10).holds) << "never";
}

TEST(JudgeExpectation, WhatNoFrameShowsDoesNotHold) {
    EXPECT_FALSE(judged(of_latency(WindowKind::during, 2.02, 2.05), 0, 10).holds) << "between two frames";
    EXPECT_FALSE(judged(of_latency(WindowKind::within, 20, 30), 0, 10).holds) << "after the end";
    EXPECT_FALSE(judged(of_latency(WindowKind::during, 8, 30), 0, 20).holds) << "unfinished";
}

}  // namespace
}  // namespace tedavis::host_sim::test_judge_expectation
