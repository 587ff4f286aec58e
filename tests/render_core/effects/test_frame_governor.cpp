#include "render_core/effects/frame_governor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::effects::test_frame_governor {
namespace {

constexpr double kDeadline_ms = 33;

base::Time at(double seconds) { return base::Time{} + base::Duration::from_seconds(seconds); }

/// Each quality level costs three quarters of the one before.
std::array<double, kQualityLevelCount> falling_from(double ms) {
    std::array<double, kQualityLevelCount> costs{};
    for (double& cost : costs) {
        cost = ms;
        ms *= 0.75;
    }
    return costs;
}

class Governor : public ::testing::Test {
protected:
    GovernorDecision frame(double seconds, double ms) { return governor_.decide({at(seconds), kDeadline_ms, falling_from(ms)}); }
    /// All frames of a span at 30 a second; the last decision.
    GovernorDecision span(double from_s, double to_s, double ms) {
        GovernorDecision last;
        for (double t = from_s; t < to_s - 1e-9; t += 1.0 / 30) last = frame(t, ms);
        return last;
    }

    FrameGovernor governor_;
};

TEST_F(Governor, WhatFitsIsLeftAlone) {
    const GovernorDecision decision = span(0, 10, 30);
    EXPECT_EQ(decision.quality_level, 0u);
    EXPECT_FALSE(decision.changed);
    EXPECT_EQ(decision.why, GovernorWhy::fits);
}

TEST_F(Governor, WhatIsTooDearGoesToTheNeededQualityLevelAtOnce) {
    static_cast<void>(span(0, 3, 20));
    const GovernorDecision decision = frame(3, 80);
    // 80, 60, 45, 33.75, 25.3: the first at most 0.85 of 33.
    EXPECT_EQ(decision.quality_level, 4u);
    EXPECT_TRUE(decision.changed);
    EXPECT_EQ(decision.why, GovernorWhy::too_dear);
    EXPECT_FALSE(frame(3.03, 80).changed);
}

TEST_F(Governor, RelaxesAfterTheDwellWithMarginToTheRicherQualityLevelAtOnce) {
    static_cast<void>(frame(0, 80));
    EXPECT_EQ(span(0.1, 1.99, 20).quality_level, 4u) << "not within the dwell";
    const GovernorDecision relaxed = frame(2, 20);
    EXPECT_TRUE(relaxed.changed);
    EXPECT_EQ(relaxed.quality_level, 0u) << "not level by level";
    EXPECT_EQ(relaxed.why, GovernorWhy::relaxed);
    EXPECT_EQ(governor_.quality_level(), 0u);
}

TEST_F(Governor, WithoutTheMarginItStays) {
    static_cast<void>(frame(0, 80));
    EXPECT_EQ(span(0.03, 60, 0.76 * kDeadline_ms).quality_level, 1u) << "level 1 has the margin, the design's picture has not";
}

TEST_F(Governor, OneDearFrameBreaksTheWait) {
    static_cast<void>(frame(0, 80));
    static_cast<void>(span(0.1, 1.9, 20));
    static_cast<void>(frame(1.9, 40));
    EXPECT_EQ(span(1.95, 3.9, 20).quality_level, 2u) << "that level stayed cheap, richer ones did not";
    EXPECT_EQ(span(3.9, 4.1, 20).quality_level, 0u);
}

TEST_F(Governor, BetweenTwoChangesTheDwellPasses) {
    static_cast<void>(frame(0, 40));
    ASSERT_EQ(governor_.quality_level(), 2u);
    const GovernorDecision waiting = frame(1, 80);
    EXPECT_EQ(waiting.quality_level, 2u);
    EXPECT_EQ(waiting.why, GovernorWhy::waits);
    EXPECT_EQ(frame(1.99, 80).why, GovernorWhy::waits);
    EXPECT_EQ(frame(2, 80).quality_level, 4u);
}

TEST_F(Governor, WhereNothingSufficesItSaysSoAndStaysAtTheLastQualityLevel) {
    EXPECT_EQ(frame(0, 500).quality_level, kQualityLevelCount - 1);
    const GovernorDecision decision = frame(5, 500);
    EXPECT_FALSE(decision.changed);
    EXPECT_EQ(decision.why, GovernorWhy::cheapest_is_too_dear);
}

TEST_F(Governor, AReturnThatDidNotLastIsNotTriedAgainSoSoon) {
    double t = 0;
    const auto changes_in = [&](double seconds, double ms) {
        int changes = 0;
        for (const double end = t + seconds; t < end; t += 1.0 / 30) changes += frame(t, ms).changed ? 1 : 0;
        return changes;
    };
    int first = 0, later = 0;
    for (int n = 0; n < 3; ++n) first += changes_in(3, 80) + changes_in(5, 20);
    for (int n = 0; n < 20; ++n) later += changes_in(3, 80) + changes_in(5, 20);
    EXPECT_GE(first, 3);
    EXPECT_LE(later, 4) << "it has learned that the cheap time does not last";
    EXPECT_EQ(changes_in(60, 20), 1) << "it comes back when the cheap time lasts";
    EXPECT_EQ(governor_.quality_level(), 0u);
}

TEST_F(Governor, AGrowingCostIsTakenForWhatItWillBe) {
    double t = 0, ms = 10;
    GovernorDecision decision;
    while (!decision.changed) {
        decision = frame(t, ms);
        t += 1.0 / 30;
        ms += 10.0 / 30;  // 10 ms a second
    }
    const std::size_t of_ramp = decision.quality_level;
    FrameGovernor jump;
    static_cast<void>(jump.decide({at(0), kDeadline_ms, falling_from(10)}));
    const std::size_t of_jump = jump.decide({at(5), kDeadline_ms, falling_from(ms)}).quality_level;
    EXPECT_GT(of_ramp, of_jump);
}

TEST_F(Governor, TheSameInstantIsTheSameFrameDecidedAgain) {
    static_cast<void>(span(0, 3, 20));
    EXPECT_EQ(frame(3, 80).quality_level, 4u);
    EXPECT_EQ(frame(3, 80).quality_level, 4u);
    EXPECT_TRUE(frame(3, 80).changed) << "compared with the frame before";
    EXPECT_EQ(frame(3, 40).quality_level, 2u) << "what arrived meanwhile counts, not what was thought before";
    EXPECT_EQ(frame(3, 20).quality_level, 0u);
    EXPECT_FALSE(frame(3, 20).changed);
}

TEST_F(Governor, TimeThatRunsBackBeginsAnew) {
    static_cast<void>(frame(10, 80));
    const GovernorDecision decision = frame(4, 20);
    EXPECT_EQ(decision.quality_level, 0u);
    EXPECT_FALSE(decision.changed);
}

TEST_F(Governor, ACopyGoesOnAlike) {
    static_cast<void>(span(0, 3, 20));
    static_cast<void>(span(3, 4, 60));
    FrameGovernor copy = governor_;
    for (double t = 4; t < 12; t += 1.0 / 30) {
        const double ms = 40 + 25 * std::sin(t);
        const GovernorDecision one = frame(t, ms), other = copy.decide({at(t), kDeadline_ms, falling_from(ms)});
        EXPECT_EQ(one.quality_level, other.quality_level);
        EXPECT_EQ(one.why, other.why);
    }
}

TEST(CostTrend, KnowsARampFromAJump) {
    CostTrend ramp, jump, flat;
    for (int n = 0; n < 20; ++n) {
        const base::Time now = at(n * 0.125);
        ramp.take(now, 10 + n * 0.5);  // 4 ms a second
        jump.take(now, n < 15 ? 10 : 80);
        flat.take(now, 10 - n * 0.1);
    }
    EXPECT_NEAR(ramp.growth(20, base::Duration::seconds(2)), 1 + 8.0 / 20, 1e-6);
    EXPECT_EQ(jump.growth(80, base::Duration::seconds(2)), 1);
    EXPECT_EQ(flat.growth(8, base::Duration::seconds(2)), 1) << "falling costs promise nothing";
    EXPECT_EQ(ramp.growth(1, base::Duration::seconds(2)), 2) << "bounded";
    EXPECT_EQ(CostTrend().growth(0, base::Duration::seconds(2)), 1);
}

TEST(GovernorTexts, EveryDecisionSaysWhy) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(GovernorWhy::count_); ++n)
        EXPECT_FALSE(to_string(static_cast<GovernorWhy>(n)).empty());
}

}  // namespace
}  // namespace tedavis::effects::test_frame_governor
