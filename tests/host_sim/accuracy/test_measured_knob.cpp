#include "host_sim/accuracy/measured_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_measured_knob {
namespace {

MeasuredLevel level(const char* name, double ms, double error) {
    MeasuredLevel level;
    level.name = name;
    level.ms = {ms, ms, ms};
    level.error = {error / 2, error, error, error, 10};
    return level;
}

MeasuredKnob knob_of(std::vector<MeasuredLevel> levels, double noise = 0.05) {
    MeasuredKnob knob;
    knob.levels = std::move(levels);
    knob.noise = noise;
    knob.reference_bound = 1e-9;
    judge(test_support::made_facts({{"a", 1}, {"b", 2}}), knob);
    return knob;
}

TEST(MeasuredKnob, NamesLevelsThatNobodyWouldChoose) {
    const MeasuredKnob knob = knob_of({level("fast", 1, 8), level("slow and worse", 3, 9), level("slow", 4, 2)});
    EXPECT_FALSE(knob.levels[0].is_dominated);
    EXPECT_TRUE(knob.levels[1].is_dominated);
    EXPECT_FALSE(knob.levels[2].is_dominated) << "slower, and more accurate";
}

TEST(MeasuredKnob, RanksNothingThatTheNoiseHides) {
    EXPECT_FALSE(knob_of({level("a", 1, 2), level("b", 1.04, 2)}).levels[1].is_dominated);
    EXPECT_TRUE(knob_of({level("a", 1, 2), level("b", 1.06, 2)}).levels[1].is_dominated) << "control: beyond the noise";
    const MeasuredKnob knob = knob_of({level("a", 1, 2), level("b", 1.04, 2)});
    EXPECT_FALSE(is_quicker(knob, knob.levels[0], knob.levels[1]));
}

TEST(MeasuredKnob, AMoreAccurateLevelIsNotDominatedForItsMeanAlone) {
    MeasuredLevel odd = level("worse at one place", 2, 8);
    odd.error.mean = 0.1;
    EXPECT_FALSE(knob_of({level("a", 1, 4), odd}).levels[1].is_dominated);
}

TEST(MeasuredKnob, AnswersByError) {
    const MeasuredKnob knob = knob_of({level("coarse", 1, 8), level("middle", 3, 2), level("fine", 9, 0.5)});
    EXPECT_EQ(cheapest_for(knob, 2)->name, "middle");
    EXPECT_EQ(cheapest_for(knob, 10)->name, "coarse");
    EXPECT_EQ(cheapest_for(knob, 0.1), nullptr);
}

TEST(MeasuredKnob, AlternativesToAnOnlyLevelAreNeitherRankedNorChosen) {
    MeasuredKnob knob;
    knob.levels = {level("ours", 4, 8), level("quicker and better", 1, 2)};
    knob.levels[1].is_offered = false;
    knob.only_level = "made up";
    judge(test_support::made_facts_of_one_level({{"ours", 1}, {"quicker and better", 2}}), knob);
    EXPECT_FALSE(knob.levels[0].is_dominated) << "by what nobody can choose";
    EXPECT_TRUE(knob_of({level("a", 4, 8), level("b", 1, 2)}).levels[0].is_dominated) << "control: else it would be";
    EXPECT_EQ(cheapest_for(knob, 5), nullptr);
    EXPECT_FALSE(knob.error_law.holds);
}

TEST(MeasuredKnob, ErrorsNearTheReferencesOwnBelongToNoLaw) {
    MeasuredKnob knob = knob_of({level("a", 1, 8), level("b", 2, 5e-9)});
    EXPECT_FALSE(knob.levels[0].is_near_reference);
    EXPECT_TRUE(knob.levels[1].is_near_reference);
}

}  // namespace
}  // namespace tedavis::host_sim::test_measured_knob
