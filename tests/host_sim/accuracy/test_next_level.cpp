#include "host_sim/accuracy/next_level.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_next_level {
namespace {

TEST(NextLevel, StatesWhatALevelBuysAndCosts) {
    test_support::MadeKnob made(4);
    MeasuredKnob knob = measure_knob(made, made.plan(7));
    knob.levels[1].bytes = 300;
    const auto steps = next_levels(knob);
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_EQ(steps[0].from->name, "1 steps");
    EXPECT_EQ(steps[0].to->name, "2 steps");
    EXPECT_DOUBLE_EQ(steps[0].error_ratio, 0.5);
    EXPECT_DOUBLE_EQ(steps[0].time_ratio, 2);
    EXPECT_DOUBLE_EQ(steps[0].more_bytes, 300);
    EXPECT_DOUBLE_EQ(steps[1].more_bytes, -300);
}

TEST(NextLevel, PassesOverLevelsThatAreDominated) {
    test_support::MadeKnob made(4);
    MeasuredKnob knob = measure_knob(made, made.plan(7));
    knob.levels[1].is_dominated = true;
    const auto steps = next_levels(knob);
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].to->name, "4 steps");
    EXPECT_DOUBLE_EQ(steps[0].time_ratio, 4);
}

TEST(NextLevel, AnOnlyLevelHasNoNextOne) { EXPECT_TRUE(next_levels(test_support::made_knob_of_one_level()).empty()); }

}  // namespace
}  // namespace tedavis::host_sim::test_next_level
