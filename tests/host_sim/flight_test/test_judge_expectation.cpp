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
    ExpectationJudge judge(expectation, {kRate_hz});
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

/// A time that is read in a report and written into a script asks for the same frame.
TEST(JudgeExpectation, APrintedTimeNamesItsFrame) {
    EXPECT_EQ(frame_time_text(122 / 30.0), "4.066 s") << "4.067 would be the next one";
    EXPECT_EQ(frame_time_text(4.1), "4.100 s") << "not 4.099, as numbers are rounded";
    for (const double rate_hz : {10.0, 30.0, 60.0, 144.0})
        for (int n = 0; n < 2000; ++n) {
            const double printed_s = std::stod(frame_time_text(n / rate_hz));
            ExpectationJudge judge(of_latency(WindowKind::at, printed_s, printed_s), {rate_hz});
            EXPECT_TRUE(judge.wants(n / rate_hz)) << n << " of " << rate_hz;
            EXPECT_FALSE(judge.wants((n - 1) / rate_hz)) << n << " of " << rate_hz;
        }
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
    EXPECT_EQ(before.expected, "what begins after 2 s, and by 4 s");
    EXPECT_EQ(before.found, "it holds already at 2.000 s");
    EXPECT_TRUE(judged(of_latency(WindowKind::within, 2, 4), 2.1, 10).holds) << "not in its first frame";
}

/// The last frame up to after_s shows what there was at that time.
TEST(JudgeExpectation, TheStateBeforeIsThatOfTheLastFrameUpToThen) {
    EXPECT_TRUE(judged(of_latency(WindowKind::within, 2.05, 4), 2.1, 10).holds) << "2.0 is the last frame up to 2.05";
    const ExpectationResult before = judged(of_latency(WindowKind::within, 2.05, 4), 2, 10);
    EXPECT_FALSE(before.holds);
    EXPECT_DOUBLE_EQ(before.failed_s, 2);
    EXPECT_EQ(before.found, "it holds already at 2.000 s");
}

/// Of a running display: the condition holds in some of its frames.
ExpectationResult judged_live(const Expectation& expectation, const std::vector<std::pair<double, bool>>& frames) {
    ExpectationJudge judge(expectation, {});
    for (const auto& [time_s, holds] : frames) {
        ObservedFrame frame;
        frame.time_s = time_s;
        frame.latency_frames = holds ? 0 : 5;
        static_cast<void>(judge.pass(time_s));
        if (judge.wants(time_s)) static_cast<void>(judge.take(frame));
    }
    return judge.result();
}

TEST(JudgeExpectation, FramesThatComeWhenTheyComeCloseWhatIsOver) {
    const Expectation during = of_latency(WindowKind::during, 2, 4);
    EXPECT_TRUE(judged_live(during, {{1.7, false}, {2.4, true}, {2.9, true}, {3.4, true}, {3.9, true}, {4.2, false}}).holds);
    EXPECT_FALSE(judged_live(during, {{2.4, true}, {2.9, true}, {3.4, true}, {3.9, true}}).holds) << "its end is not known";
    EXPECT_DOUBLE_EQ(judged_live(during, {{2.4, true}, {2.8, false}, {4.2, true}}).failed_s, 2.8);
    Expectation within = of_latency(WindowKind::within, 2, 4);
    EXPECT_DOUBLE_EQ(*judged_live(within, {{1.7, false}, {2.4, true}}).reached_s, 2.4) << "not yet at 1.7";
    EXPECT_EQ(judged_live(within, {{1.7, true}, {2.4, true}}).found, "it holds already at 1.700 s");
    EXPECT_DOUBLE_EQ(judged_live(within, {{1.7, false}, {2.4, false}, {3.9, false}, {4.1, true}}).failed_s, 3.9);
    within.stays = true;
    EXPECT_TRUE(judged_live(within, {{1.7, false}, {3.3, true}, {3.7, true}, {4.1, false}}).holds);
    EXPECT_FALSE(judged_live(within, {{1.7, false}, {3.3, true}, {3.7, false}, {4.1, false}}).holds);
}

/// What the screen shows while it stands still is not what the flight is.
TEST(JudgeExpectation, ADisplayThatFreezesDoesNotHold) {
    const ExpectationResult frozen = judged_live(of_latency(WindowKind::during, 2, 6), {{1.9, true}, {2.03, true}, {17, true}});
    EXPECT_FALSE(frozen.holds);
    EXPECT_EQ(frozen.key, "time");
    EXPECT_EQ(frozen.found, "none from 2.03 s to 6.00 s");
    EXPECT_DOUBLE_EQ(frozen.failed_s, 2.03);
    const Expectation during = of_latency(WindowKind::during, 2, 4);
    EXPECT_FALSE(judged_live(during, {{1.9, true}, {2.7, true}, {3.1, true}, {3.6, true}, {4.1, true}}).holds) << "from 2 s on";
    EXPECT_FALSE(judged_live(during, {{2.2, true}, {2.6, true}, {3.2, true}, {3.6, true}, {4.1, true}}).holds) << "between";
    EXPECT_TRUE(judged_live(during, {{1.4, true}, {2.5, true}, {3, true}, {3.5, true}, {9, true}}).holds) << "outside";
    Expectation stays = of_latency(WindowKind::within, 2, 4);
    EXPECT_TRUE(judged_live(stays, {{1.9, false}, {2.5, true}, {17, true}}).holds) << "reached, and that is all";
    stays.stays = true;
    const ExpectationResult lost = judged_live(stays, {{1.9, false}, {2.5, true}, {17, true}});
    EXPECT_FALSE(lost.holds);
    EXPECT_EQ(lost.key, "time");
    EXPECT_TRUE(judged_live(stays, {{1.9, false}, {3.6, true}, {17, true}}).holds) << "before it is reached none is missing";
}

TEST(JudgeExpectation, AWindowWithoutAFrameOfARunningDisplayDoesNotHold) {
    const std::vector<std::pair<double, bool>> frames = {{1.9, false}, {4.5, true}};
    for (const WindowKind kind : {WindowKind::during, WindowKind::within}) {
        const ExpectationResult result = judged_live(of_latency(kind, 2, 4), frames);
        EXPECT_FALSE(result.holds);
        EXPECT_EQ(result.key, "time");
        EXPECT_EQ(result.found, "none");
    }
    EXPECT_FALSE(judged_live(of_latency(WindowKind::at, 2, 2), frames).holds) << "so late a frame shows another time";
    EXPECT_TRUE(judged_live(of_latency(WindowKind::at, 4.1, 4.1), frames).holds);
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
