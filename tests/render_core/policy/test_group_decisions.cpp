#include "render_core/policy/group_decisions.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/policy_states.hpp"

namespace tedavis::policy::test_group_decisions {
namespace {

using flight::Signal;
using test_support::everything_valid;
using test_support::kPolicyNow;

TEST(GroupDecisions, TakesTheFirstValidSourceThenAStaleOne) {
    flight::AircraftState state = everything_valid();
    EXPECT_EQ(GroupDecisions(state, kPolicyNow).decision(SignalGroup::airspeed).source, Signal::indicated_airspeed);
    state[Signal::indicated_airspeed] = {60, kPolicyNow, base::Quality::bad};
    const ElementDecision second = GroupDecisions(state, kPolicyNow).decision(SignalGroup::airspeed);
    EXPECT_NE(second.source, Signal::indicated_airspeed);
    EXPECT_TRUE(shows_value(second.show));
}

TEST(GroupDecisions, WithoutASourceTheConsequencesSayWhetherItFailed) {
    const flight::AircraftState nothing;
    GroupDecisions groups(nothing, kPolicyNow);
    EXPECT_EQ(groups.decision(SignalGroup::pitch).show, ElementShow::absent);
    groups.add_consequences(SignalGroup::pitch, kFailElement | kFlag);
    EXPECT_EQ(groups.decision(SignalGroup::pitch).show, ElementShow::failed);
    EXPECT_EQ(groups.decision(SignalGroup::roll).show, ElementShow::absent) << "control: of another group";
}

TEST(GroupDecisions, AMagneticHeadingTurnsTheViewWithAVariationAlone) {
    flight::AircraftState state = everything_valid();
    EXPECT_TRUE(GroupDecisions(state, kPolicyNow).turns_view(Signal::magnetic_heading));
    state[Signal::magnetic_variation] = {};
    EXPECT_FALSE(GroupDecisions(state, kPolicyNow).turns_view(Signal::magnetic_heading));
    EXPECT_TRUE(GroupDecisions(state, kPolicyNow).turns_view(Signal::true_heading));
}

TEST(GroupDecisions, TheWorseOfTwoCounts) {
    flight::AircraftState state = everything_valid();
    EXPECT_EQ(GroupDecisions(state, kPolicyNow).worse_of(SignalGroup::pitch, SignalGroup::roll).show, ElementShow::normal);
    state[Signal::roll] = {};
    GroupDecisions groups(state, kPolicyNow);
    EXPECT_EQ(groups.worse_of(SignalGroup::pitch, SignalGroup::roll).show, ElementShow::absent);
    groups.add_consequences(SignalGroup::roll, kFailElement);
    EXPECT_EQ(groups.worse_of(SignalGroup::pitch, SignalGroup::roll).show, ElementShow::failed);
    EXPECT_EQ(groups.worse_of(SignalGroup::roll, SignalGroup::pitch).show, ElementShow::failed);
}

}  // namespace
}  // namespace tedavis::policy::test_group_decisions
