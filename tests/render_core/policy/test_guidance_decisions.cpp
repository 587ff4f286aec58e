// What the failure policy decides on course, deviations and minimums.
#include <gtest/gtest.h>

#include "tests/support/flights/policy_states.hpp"

namespace tedavis::policy::test_guidance_decisions {
namespace {

using base::SignalState;
using flight::AircraftState;
using flight::Signal;
using test_support::decide_on;
using test_support::everything_valid;
using test_support::has_flag;
using test_support::kPolicyNow;
using test_support::put_signal;

void select_source(AircraftState& state, flight::NavigationSource source) {
    state[Signal::navigation_source] = {static_cast<double>(source), kPolicyNow};
}

TEST(GuidanceDecisions, CourseAndDeviationsComeFromTheNavigationSourceAlone) {
    const struct {
        flight::NavigationSource source;
        Signal course, lateral, vertical;
    } cases[] = {
        {flight::NavigationSource::radio1, Signal::selected_course, Signal::ils1_localizer_deviation,
         Signal::ils1_glideslope_deviation},
        {flight::NavigationSource::radio2, Signal::selected_course, Signal::ils2_localizer_deviation,
         Signal::ils2_glideslope_deviation},
        {flight::NavigationSource::gnss, Signal::desired_track, Signal::cross_track_deviation, Signal::gnss_vertical_deviation},
    };
    for (const auto& expected : cases) {
        AircraftState state = everything_valid();
        select_source(state, expected.source);
        DisplayDecisions decisions = decide_on(state);
        EXPECT_EQ(decisions[Element::course].source, expected.course);
        EXPECT_EQ(decisions[Element::lateral_deviation].source, expected.lateral);
        EXPECT_EQ(decisions[Element::vertical_deviation].source, expected.vertical);
        put_signal(state, expected.lateral, SignalState::lost);
        decisions = decide_on(state);
        EXPECT_EQ(decisions[Element::lateral_deviation].show, ElementShow::failed) << "never from another receiver";
        EXPECT_EQ(decisions[Element::lateral_deviation].source, Signal::count_);
        EXPECT_EQ(decisions[Element::vertical_deviation].show, ElementShow::normal);
    }
    AircraftState state = everything_valid();
    select_source(state, flight::NavigationSource::none);
    EXPECT_EQ(decide_on(state)[Element::lateral_deviation].show, ElementShow::absent);
    put_signal(state, Signal::navigation_source, SignalState::missing);
    EXPECT_EQ(decide_on(state)[Element::lateral_deviation].source, Signal::ils1_localizer_deviation);
}

TEST(GuidanceDecisions, ADeviationIsAsGoodAsTheStatementOfItsReceiver) {
    const struct {
        SignalState state;
        ElementShow show;
    } cases[] = {{SignalState::stale, ElementShow::flagged},
                 {SignalState::lost, ElementShow::failed},
                 {SignalState::invalid, ElementShow::failed}};
    for (const auto& expected : cases) {
        AircraftState state = everything_valid();
        put_signal(state, Signal::navigation_source, expected.state);
        put_signal(state, Signal::ils1_glideslope_deviation, SignalState::missing);
        const DisplayDecisions decisions = decide_on(state);
        EXPECT_EQ(decisions[Element::course].show, expected.show);
        EXPECT_EQ(decisions[Element::lateral_deviation].show, expected.show);
        EXPECT_EQ(decisions[Element::lateral_deviation].source == Signal::count_, expected.show == ElementShow::failed);
        EXPECT_EQ(decisions[Element::vertical_deviation].show, ElementShow::absent) << "this receiver has no glide path";
    }
}

TEST(GuidanceDecisions, AMinimumInTheGroundIsRemovedWhereItMatters) {
    AircraftState state = everything_valid();
    DisplayConditions conditions = test_support::good_conditions();
    conditions.phase.phase = flight::kApproachFinal;
    state[Signal::baro_altitude] = {590, kPolicyNow};
    state[Signal::radio_height] = {90, kPolicyNow};
    state[Signal::minimum_altitude] = {510, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions)[Element::baro_minimum].show, ElementShow::normal);
    state[Signal::minimum_altitude] = {490, kPolicyNow};
    const DisplayDecisions decisions = decide_on(state, conditions);
    EXPECT_EQ(decisions[Element::baro_minimum].show, ElementShow::failed);
    EXPECT_TRUE(has_flag(decisions, "minimum_altitude.below_ground"));
    state[Signal::baro_altitude] = {620, kPolicyNow};
    state[Signal::radio_height] = {120, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions)[Element::baro_minimum].show, ElementShow::normal) << "above a hill on the way";
    conditions.phase.phase = flight::kTakeoffFirstClimb;
    state[Signal::baro_altitude] = {590, kPolicyNow};
    state[Signal::radio_height] = {90, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions)[Element::baro_minimum].show, ElementShow::normal) << "that of the destination";
}

TEST(GuidanceDecisions, MinimumsAreReachedOnAnApproachInTheAir) {
    const auto state_at = [](double height_m, const flight::FlightPhase& phase) {
        AircraftState state = everything_valid();
        state[Signal::radio_height] = {height_m, kPolicyNow};
        state[Signal::decision_height] = {60, kPolicyNow};
        DisplayConditions conditions = test_support::good_conditions();
        conditions.phase.phase = phase;
        return decide_on(state, conditions).radio_minimum;
    };
    EXPECT_EQ(state_at(200, flight::kApproachFinal), MinimumsState::above);
    EXPECT_EQ(state_at(85, flight::kApproachFinal), MinimumsState::near);
    EXPECT_EQ(state_at(59, flight::kApproachFinal), MinimumsState::at_or_below);
    EXPECT_EQ(state_at(59, flight::kTakeoffFirstClimb), MinimumsState::none);
    EXPECT_EQ(state_at(2, flight::kApproachFinal), MinimumsState::at_or_below) << "in the flare";
    EXPECT_EQ(state_at(0.5, flight::kApproachFinal), MinimumsState::none) << "landed";
}

TEST(GuidanceDecisions, EachMinimumCountsByItself) {
    AircraftState state = everything_valid();
    DisplayConditions conditions = test_support::good_conditions();
    conditions.phase.phase = flight::kApproachFinal;
    state[Signal::radio_height] = {100, kPolicyNow};
    state[Signal::decision_height] = {60, kPolicyNow};
    state[Signal::baro_altitude] = {500, kPolicyNow};
    state[Signal::minimum_altitude] = {520, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions).radio_minimum, MinimumsState::above);
    EXPECT_EQ(decide_on(state, conditions).baro_minimum, MinimumsState::at_or_below);
    EXPECT_TRUE(test_support::has_notice(decide_on(state, conditions), "MINIMUMS")) << "one is enough";
    put_signal(state, Signal::radio_height, SignalState::missing);
    EXPECT_EQ(decide_on(state, conditions).radio_minimum, MinimumsState::none)
        << "the height over the database is no radio height";
}

TEST(GuidanceDecisions, AnUnknownPhaseMayBeAnApproachWhileItDescends) {
    AircraftState state = everything_valid();
    DisplayConditions conditions = test_support::good_conditions();
    conditions.phase.phase = flight::FlightPhase();
    state[Signal::radio_height] = {50, kPolicyNow};
    state[Signal::decision_height] = {60, kPolicyNow};
    state[Signal::vertical_speed] = {-3, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions).radio_minimum, MinimumsState::at_or_below);
    state[Signal::vertical_speed] = {3, kPolicyNow};
    EXPECT_EQ(decide_on(state, conditions).radio_minimum, MinimumsState::none);
}

TEST(GuidanceDecisions, WithoutARadioMinimumTheAltimetersCounts) {
    AircraftState state = everything_valid();
    DisplayConditions conditions = test_support::good_conditions();
    conditions.phase.phase = flight::kApproachFinal;
    state[Signal::radio_height] = {100, kPolicyNow};
    state[Signal::baro_altitude] = {500, kPolicyNow};
    state[Signal::minimum_altitude] = {520, kPolicyNow};
    put_signal(state, Signal::decision_height, SignalState::missing);
    EXPECT_EQ(decide_on(state, conditions).baro_minimum, MinimumsState::at_or_below);
    EXPECT_TRUE(test_support::has_notice(decide_on(state, conditions), "MINIMUMS"));
    put_signal(state, Signal::minimum_altitude, SignalState::stale);
    EXPECT_EQ(decide_on(state, conditions).baro_minimum, MinimumsState::none) << "a stale minimum states nothing";
}

}  // namespace
}  // namespace tedavis::policy::test_guidance_decisions
