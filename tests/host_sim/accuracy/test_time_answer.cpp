#include "host_sim/accuracy/time_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_time_answer {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Levels of 1, 2, 4, 8 and 16 ms a frame, each with half of the error of the one before, without any spread.
MeasuredKnob frames() {
    MeasuredKnob knob = test_support::made_report().knobs[0];
    knob.name = kFrameSettings;
    return knob;
}

std::string name_within(const MeasuredKnob& knob, double budget_ms) {
    const std::optional<TimeAnswer> answer = answer_within(knob, budget_ms);
    return answer ? answer->level->name : "";
}

TEST(TimeAnswer, IsTheMostAccurateLevelThatFits) {
    EXPECT_EQ(name_within(frames(), 9), "8 steps");
    EXPECT_EQ(name_within(frames(), 100), "16 steps");
    EXPECT_EQ(name_within(frames(), 0.5), "");
}

TEST(TimeAnswer, IsNoLevelOfWhichOnlyTheMedianFits) {
    MeasuredKnob knob = frames();
    knob.levels[3].kept_ms = 9.5;  // 95 of 100 frames; the median is 8
    EXPECT_EQ(name_within(knob, 9), "4 steps");
    EXPECT_EQ(name_within(knob, 10), "8 steps") << "control: 95 of 100 frames fit";
}

TEST(TimeAnswer, IsNoLevelWhoseSpreadTimesTheNoiseDoesNotFit) {
    MeasuredKnob knob = frames();
    knob.levels[3].kept_ms = 8.5;
    EXPECT_EQ(name_within(knob, 9), "8 steps") << "control: without noise it is the answer";
    knob.noise = 0.1;
    EXPECT_EQ(name_within(knob, 9), "4 steps") << "8.5 ms and a tenth is 9.35 ms";
    EXPECT_EQ(name_within(knob, 9.4), "8 steps");
}

TEST(TimeAnswer, IsNoLevelThatTheDearestMomentKeepsFromFitting) {
    MeasuredKnob knob = frames();
    EXPECT_EQ(name_within(knob, 9), "8 steps") << "control: no moment is dearer than the samples";
    knob.dearest = 1.25;
    EXPECT_EQ(name_within(knob, 9), "4 steps");
    knob.noise = 0.2;
    EXPECT_EQ(name_within(knob, 5.9), "2 steps") << "both factors: 4 ms need 6 ms";
    EXPECT_EQ(name_within(knob, 6.1), "4 steps");
    EXPECT_NEAR(time_need(knob, knob.levels[2]).margin, 0.5, 1e-12);
}

TEST(TimeAnswer, ExpectsMoreFramesWhereMoreFit) {
    MeasuredKnob knob = frames();
    knob.levels[3].kept_99_ms = 12;
    EXPECT_DOUBLE_EQ(answer_within(knob, 11)->expected_share, 0.95);
    EXPECT_DOUBLE_EQ(answer_within(knob, 12)->expected_share, 0.99);
    knob.noise = 0.1;
    EXPECT_DOUBLE_EQ(answer_within(knob, 12)->expected_share, 0.95) << "the margin counts here too";
}

TEST(TimeAnswer, OfOtherSettingsIsOneOfAllSamplesTogether) {
    MeasuredKnob knob = test_support::made_report().knobs[0];
    EXPECT_EQ(name_within(knob, 13), "4 steps") << "three samples of 4 ms";
    knob.levels[2].ms.p95 = 14;
    EXPECT_EQ(name_within(knob, 13), "2 steps");
    EXPECT_THAT(need_words(knob, time_need(knob, knob.levels[2])), HasSubstr("95 of 100 rounds took at most 14 ms"));
    EXPECT_THAT(need_words(knob, time_need(knob, knob.levels[2])), Not(HasSubstr("moments"))) << "it has none";
}

TEST(TimeAnswer, ChoosesNoAlternativeThatTheProductDoesNotOffer) {
    const MeasuredKnob knob = test_support::made_knob_of_one_level();
    EXPECT_EQ(name_within(knob, 100), "ours");
    EXPECT_EQ(name_within(knob, 2), "");
    EXPECT_EQ(least_needing(knob).name, "ours");
}

TEST(TimeAnswer, TheLevelThatNeedsLeastIsNotTheOneWithTheShortestMedian) {
    MeasuredKnob knob = frames();
    EXPECT_EQ(least_needing(knob).name, "1 steps") << "control";
    knob.levels[0].kept_ms = 3;
    EXPECT_EQ(least_needing(knob).name, "2 steps");
}

}  // namespace
}  // namespace tedavis::host_sim::test_time_answer
