#include "host_sim/accuracy/measure_knob.hpp"

#include <gtest/gtest.h>

#include <set>

#include "host_sim/user_error.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_measure_knob {
namespace {

using test_support::MadeKnob;

TEST(MeasureKnob, FindsErrorsTimesAndTheLaw) {
    MadeKnob knob(5);
    const MeasuredKnob measured = measure_knob(knob, knob.plan(10));
    ASSERT_EQ(measured.levels.size(), 5u);
    const MeasuredLevel& third = measured.levels[2];
    EXPECT_EQ(third.name, "4 steps");
    EXPECT_DOUBLE_EQ(third.error.max, 0.25);
    EXPECT_EQ(third.error.count, 6u);
    EXPECT_EQ(third.worst_place, "sample 1, error 1");
    EXPECT_DOUBLE_EQ(third.ms.median, 12) << "three samples of four milliseconds";
    EXPECT_NEAR(measured.error_law.exponent, -1, 1e-12);
    EXPECT_NEAR(measured.time_law.exponent, 1, 1e-12);
    EXPECT_TRUE(measured.law_agrees);
    EXPECT_EQ(measured.rounds, 10u);
    EXPECT_EQ(measured.reference, "the truth");
}

TEST(MeasureKnob, CountsWhatTheLevelsWorkThrough) {
    MadeKnob knob(5);
    const MeasuredKnob measured = measure_knob(knob, knob.plan(8));
    ASSERT_TRUE(measured.work);
    EXPECT_EQ(measured.work->thing, "steps taken");
    EXPECT_EQ(measured.work->counts, (std::vector<double>{1, 2, 4, 8, 16}));
    EXPECT_NEAR(measured.work->law.exponent, 1, 1e-12);
    EXPECT_TRUE(measured.work->law_agrees);
    EXPECT_NEAR(measured.work->ms_per_thousand, 1000, 1e-6) << "a step takes a millisecond";
    EXPECT_NEAR(measured.work->fixed_ms, 0, 1e-9);
}

TEST(MeasureKnob, DoesNotTimeWhatIsPrepared) {
    MadeKnob knob(3);
    knob.preparation_ms = 50;
    EXPECT_DOUBLE_EQ(measure_knob(knob, knob.plan(8)).levels[2].ms.median, 12) << "three samples of four milliseconds";
    EXPECT_GT(knob.now_ms, 8 * 3 * 3 * 50) << "control: it was prepared";
}

TEST(MeasureKnob, MeasuresOneLevelAlone) {
    MadeKnob knob(test_support::made_facts_of_one_level({{"ours", 0}}));
    const MeasuredKnob measured = measure_knob(knob, knob.plan(6));
    ASSERT_EQ(measured.levels.size(), 1u);
    EXPECT_TRUE(measured.levels[0].is_offered && measured.has_one_level());
    EXPECT_DOUBLE_EQ(measured.levels[0].ms.median, 3);
    EXPECT_DOUBLE_EQ(measured.noise, 0);
}

TEST(MeasureKnob, TakesLevelsInTurnsThatChange) {
    MadeKnob knob(4);
    static_cast<void>(measure_knob(knob, knob.plan(8)));
    std::set<std::size_t> first;
    for (std::size_t round = 0; round < 8; ++round) {
        std::set<std::size_t> in_round;
        for (std::size_t n = 0; n < 12; ++n) in_round.insert(knob.runs[round * 12 + n].first);
        EXPECT_EQ(in_round.size(), 4u) << "every level in every round";
        first.insert(knob.runs[round * 12].first);
    }
    EXPECT_EQ(first.size(), 4u) << "each is the first one in turn";
}

TEST(MeasureKnob, WhatDiffersBetweenOddAndEvenRoundsIsNoise) {
    MadeKnob quiet(3), noisy(3);
    EXPECT_DOUBLE_EQ(measure_knob(quiet, quiet.plan(8)).noise, 0) << "control: a clock without noise";
    noisy.slowness = [](std::size_t round) { return round % 2 == 0 ? 1.0 : 1.3; };
    EXPECT_GT(measure_knob(noisy, noisy.plan(8)).noise, 0.2);
}

TEST(MeasureKnob, MomentsSayHowMuchDearerThanTheSlowestSampleAFlightCanBe) {
    MadeKnob knob(3), quick(3), none(3);
    knob.moment_times = {0.5, 1.5, 1};
    const MeasuredKnob measured = measure_knob(knob, knob.plan(8));
    EXPECT_DOUBLE_EQ(measured.dearest, 1.5);
    EXPECT_EQ(measured.moments, 3u);
    EXPECT_DOUBLE_EQ(measured.levels[1].kept_ms, 2) << "they do not count as samples";
    EXPECT_DOUBLE_EQ(measured.levels[1].ms.median, 6);
    quick.moment_times = {0.5, 0.25};
    EXPECT_DOUBLE_EQ(measure_knob(quick, quick.plan(8)).dearest, 1) << "a sample is dearer";
    EXPECT_DOUBLE_EQ(measure_knob(none, none.plan(8)).dearest, 1);
}

TEST(MeasureKnob, StopsAfterItsTimeButNotBeforeTheLeastRounds) {
    MadeKnob knob(3);
    MeasuringPlan plan = knob.plan(100);
    plan.most_s = 1e-3;
    EXPECT_EQ(measure_knob(knob, plan).rounds, MeasuringPlan::kMinRounds);
}

TEST(MeasureKnob, LetsTheCallerStopIt) {
    MadeKnob knob(3);
    MeasuringPlan plan = knob.plan(100);
    plan.progress = [](std::size_t done, std::size_t) {
        if (done == 2) throw Interrupted("stopped");
    };
    EXPECT_THROW(static_cast<void>(measure_knob(knob, plan)), Interrupted);
    EXPECT_EQ(knob.runs.size(), 2u * 3u * 3u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_measure_knob
