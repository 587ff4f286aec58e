#include "render_core/effects/frame_governor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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
    GovernorDecision frame(double seconds, double ms) {
        return governor_.decide({at(seconds), kDeadline_ms, falling_from(ms), kQualityLevelCount});
    }
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
    static_cast<void>(jump.decide({at(0), kDeadline_ms, falling_from(10), kQualityLevelCount}));
    const std::size_t of_jump = jump.decide({at(5), kDeadline_ms, falling_from(ms), kQualityLevelCount}).quality_level;
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
        const GovernorDecision one = frame(t, ms),
                               other = copy.decide({at(t), kDeadline_ms, falling_from(ms), kQualityLevelCount});
        EXPECT_EQ(one.quality_level, other.quality_level);
        EXPECT_EQ(one.why, other.why);
    }
}

/// A front of 1 to 6 levels, and what a frame costs at each: the later ones at most as much, and often exactly as much, as where
/// nothing is in view that a level leaves out.
struct Front {
    QualityLevels levels;
    std::array<double, kQualityLevelCount> ms{};
};

class RandomFronts {
public:
    Front next() {
        Front front;
        front.levels.count = static_cast<std::uint8_t>(1 + std::uniform_int_distribution<int>(0, 5)(random_));
        double ms = between(5, 120);
        for (std::size_t n = 0; n < front.levels.count; ++n) {
            const double x = static_cast<double>(n);
            front.levels.at[n] = {1 + x, 1 / (1 + x), {}, 100 - 10 * x, 1 + x, x};
            front.ms[n] = ms;
            if (between(0, 1) < 0.6) ms *= between(0.4, 1);
        }
        return front;
    }
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

private:
    std::mt19937 random_{33};
};

/// Whether another level is at least as cheap in this frame, and better.
bool is_dominated(const Front& front, std::size_t chosen) {
    const auto in_frame = [&](std::size_t n) {
        QualityLevel level = front.levels.at[n];
        level.ms = front.ms[n];
        return level;
    };
    for (std::size_t n = 0; n < front.levels.count; ++n)
        if (dominates(in_frame(n), in_frame(chosen))) return true;
    return false;
}

/// What it chooses is within the limits where anything is, and no other level would have been better.
TEST(GovernorOverFronts, NeverChangesToADominatedLevel) {
    RandomFronts fronts;
    int changes = 0, control = 0;
    for (int n = 0; n < 5000; ++n) {
        FrameGovernor governor;
        for (int frame = 0; frame < 4; ++frame) {
            const Front front = fronts.next();
            const GovernorInput input{at(3.0 * frame), kDeadline_ms, front.ms, front.levels.count};
            if (governor.quality_level() >= input.level_count) break;  // another calibration: hold() begins anew
            const GovernorDecision decision = governor.decide(input);
            ASSERT_LT(decision.quality_level, input.level_count);
            if (!decision.changed) continue;
            ++changes;
            EXPECT_FALSE(is_dominated(front, decision.quality_level)) << n;
            control += is_dominated(front, input.level_count - 1) ? 1 : 0;
        }
    }
    EXPECT_GT(changes, 1000);
    EXPECT_GT(control, 100) << "the last level of all would often have been a dominated one";
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
