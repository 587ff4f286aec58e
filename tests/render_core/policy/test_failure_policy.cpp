#include "render_core/policy/failure_policy.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/support/flights/policy_states.hpp"

namespace tedavis::policy::test_failure_policy {
namespace {

using base::SignalState;
using flight::AircraftState;
using flight::Signal;
using test_support::decide_on;
using test_support::everything_valid;
using test_support::good_conditions;
using test_support::has_flag;
using test_support::has_notice;
using test_support::kBadStates;
using test_support::kPolicyNow;
using test_support::map_conditions;
using test_support::put_signal;

DisplayDecisions decide_track_up(const AircraftState& state) {
    design::DesignSettings design = design::default_design_settings();
    design.view.map_orientation = design::MapOrientation::track_up;
    return decide_display(state, kPolicyNow, map_conditions(), design);
}

TEST(FailurePolicy, TheMapTurnsToTheTrackThenToTheHeadingThenToNorth) {
    AircraftState state = everything_valid();
    EXPECT_EQ(decide_track_up(state)[Element::map_up].source, Signal::true_track);
    EXPECT_EQ(decide_track_up(state)[Element::map_up].show, ElementShow::normal);
    EXPECT_TRUE(decide_track_up(state).flags.empty());
    for (const SignalState bad : kBadStates) {
        put_signal(state, Signal::true_track, bad);
        const DisplayDecisions by_heading = decide_track_up(state);
        EXPECT_EQ(by_heading[Element::map_up].source, Signal::true_heading);
        EXPECT_EQ(by_heading[Element::map_up].show, ElementShow::substituted);
        EXPECT_TRUE(has_flag(by_heading, "map.heading_up"));
        EXPECT_FALSE(has_notice(by_heading, "MAP NORTH UP"));
        AircraftState without = state;
        for (const Signal lost : {Signal::true_heading, Signal::magnetic_heading}) put_signal(without, lost, SignalState::lost);
        const DisplayDecisions north = decide_track_up(without);
        EXPECT_EQ(north[Element::map_up].source, Signal::count_);
        EXPECT_EQ(north[Element::map_up].show, ElementShow::flagged);
        EXPECT_TRUE(has_flag(north, "map.north_up"));
        EXPECT_TRUE(has_notice(north, "MAP NORTH UP"));
        EXPECT_TRUE(north.show_terrain);
    }
    EXPECT_EQ(decide_on(state, map_conditions())[Element::map_up].show, ElementShow::normal) << "north was asked for";
    EXPECT_FALSE(has_flag(decide_on(state, map_conditions()), "map.heading_up"));
    design::DesignSettings track_up = design::default_design_settings();
    track_up.view.map_orientation = design::MapOrientation::track_up;
    EXPECT_FALSE(has_flag(decide_display(state, kPolicyNow, good_conditions(), track_up), "map.heading_up")) << "no map, no flag";
}

TEST(FailurePolicy, AWindIsAsGoodAsTheWorseOfItsSignals) {
    const std::pair<SignalState, ElementShow> kShows[] = {{SignalState::missing, ElementShow::absent},
                                                          {SignalState::stale, ElementShow::flagged},
                                                          {SignalState::lost, ElementShow::failed},
                                                          {SignalState::invalid, ElementShow::failed}};
    for (const auto& [bad, show] : kShows) {
        for (const Signal signal : {Signal::wind_speed, Signal::wind_direction}) {
            AircraftState state = everything_valid();
            put_signal(state, signal, bad);
            EXPECT_EQ(decide_on(state)[Element::wind].show, show) << to_string(signal) << " " << to_string(bad);
            EXPECT_EQ(decide_on(state)[Element::outside_temperature].show, ElementShow::normal);
        }
    }
    EXPECT_EQ(decide_on(everything_valid())[Element::wind].show, ElementShow::normal);
}

TEST(FailurePolicy, TheMapFlagsItsPositionInPlace) {
    AircraftState state = everything_valid();
    EXPECT_EQ(decide_on(state, map_conditions())[Element::position].show, ElementShow::normal);
    for (const SignalState bad : kBadStates) {
        state.own_ship.state = bad;
        const DisplayDecisions decisions = decide_on(state, map_conditions());
        EXPECT_EQ(decisions[Element::position].show, bad == SignalState::stale ? ElementShow::flagged : ElementShow::failed);
        EXPECT_EQ(decisions[Element::map_up].show, bad == SignalState::stale ? ElementShow::normal : ElementShow::absent);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_FALSE(decisions.plain_horizon);
        EXPECT_TRUE(has_notice(decisions, "TERRAIN OFF"));
    }
}

TEST(FailurePolicy, TheMapHasNoRecoveryPicture) {
    AircraftState state = everything_valid();
    state[Signal::roll] = {base::radians(179), kPolicyNow};
    EXPECT_TRUE(decide_on(state).unusual_attitude);
    EXPECT_FALSE(decide_on(state, map_conditions()).unusual_attitude);
    EXPECT_TRUE(decide_on(state, map_conditions()).show_warning_colors);
}

TEST(FailurePolicy, EverythingValidShowsEverythingAndFlagsNothing) {
    const DisplayDecisions decisions = decide_on(everything_valid());
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_TRUE(decisions.show_warning_colors);
    EXPECT_FALSE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.plain_horizon);
    EXPECT_TRUE(decisions.flags.empty());
    for (const ElementDecision& element : decisions.elements) EXPECT_EQ(element.show, ElementShow::normal);
    EXPECT_EQ(decisions.view_heading, Signal::true_heading);
    ASSERT_EQ(decisions.notices.size(), 1u);
    EXPECT_EQ(decisions.notices[0].text.view(), "NOT FOR NAVIGATION");
}

TEST(FailurePolicy, NothingReceivedShowsNoInformationAtAll) {
    const DisplayDecisions decisions = decide_on(AircraftState{});
    EXPECT_FALSE(decisions.show_terrain);
    EXPECT_FALSE(decisions.plain_horizon);
    EXPECT_EQ(decisions.view_heading, Signal::count_);
    for (const ElementDecision& element : decisions.elements)
        EXPECT_TRUE(element.show == ElementShow::failed || element.show == ElementShow::absent);
    EXPECT_TRUE(has_notice(decisions, "NO GPS POSITION"));
    EXPECT_TRUE(has_flag(decisions, "own_ship.missing"));
}

TEST(FailurePolicy, OwnShipEstimateNotValidRemovesTerrain) {
    for (SignalState bad : kBadStates) {
        AircraftState state = everything_valid();
        state.own_ship.state = bad;
        const DisplayDecisions decisions = decide_on(state);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_TRUE(decisions.plain_horizon);
        EXPECT_EQ(decisions[Element::flight_path].show, ElementShow::failed);
        EXPECT_TRUE(has_flag(decisions, std::string("own_ship.") + to_string(bad)));
        EXPECT_TRUE(has_notice(decisions, bad == SignalState::stale ? "GPS POSITION STALE" : "NO GPS POSITION"));
        EXPECT_TRUE(has_notice(decisions, "TERRAIN OFF"));
    }
}

TEST(FailurePolicy, HeightWithoutGeometryKeepsTerrainDegradedAndUncolored) {
    AircraftState state = everything_valid();
    state.own_ship.height_is_geometric = false;
    const DisplayDecisions decisions = decide_on(state);
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_TRUE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.show_warning_colors);
    EXPECT_TRUE(has_flag(decisions, "terrain.degraded"));
    EXPECT_TRUE(has_notice(decisions, "TERRAIN DEGRADED"));
}

TEST(FailurePolicy, AHeightOnTheAltimetersSettingKeepsTerrainWithoutColors) {
    AircraftState state = everything_valid();
    put_signal(state, Signal::ellipsoid_height, SignalState::missing);
    put_signal(state, Signal::true_altitude, SignalState::missing);
    state.own_ship.height_is_geometric = false;
    state.own_ship.height_is_on_qnh = true;
    DisplayDecisions decisions = decide_on(state);
    EXPECT_TRUE(decisions.show_terrain);
    EXPECT_FALSE(decisions.terrain_degraded);
    EXPECT_FALSE(decisions.show_warning_colors);
    EXPECT_TRUE(has_flag(decisions, "own_ship.height_on_qnh"));
    for (const Signal needed : {Signal::baro_altitude, Signal::baro_setting}) {
        AircraftState without = state;
        put_signal(without, needed, SignalState::missing);
        EXPECT_TRUE(decide_on(without).terrain_degraded) << to_string(needed);
    }
}

TEST(FailurePolicy, TerrainThatIsNotAsItShouldBeIsShownAndSaid) {
    struct Case {
        bool DisplayConditions::*condition;
        const char *notice, *flag;
    };
    for (const Case& said : {Case{&DisplayConditions::terrain_is_coarse, "TERRAIN COARSE", "terrain.coarse"},
                             Case{&DisplayConditions::terrain_ends, "DATABASE ENDS", "terrain.ends"},
                             Case{&DisplayConditions::image_is_missing, "NO TERRAIN IMAGE", "terrain.no_image"}}) {
        DisplayConditions conditions = good_conditions();
        conditions.*said.condition = true;
        const DisplayDecisions decisions = decide_on(everything_valid(), conditions);
        EXPECT_TRUE(decisions.show_terrain);
        EXPECT_TRUE(has_notice(decisions, said.notice));
        EXPECT_TRUE(has_flag(decisions, said.flag));
        conditions.terrain = TerrainSource::outside;
        EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), said.notice)) << "no terrain is shown";
    }
}

TEST(FailurePolicy, AccuracyBeyondItsLimitDegrades) {
    for (Signal accuracy : {Signal::horizontal_accuracy, Signal::vertical_accuracy}) {
        AircraftState state = everything_valid();
        const auto limits = design::default_design_settings().degradation;
        const double limit = accuracy == Signal::horizontal_accuracy ? limits.horizontal_accuracy_m : limits.vertical_accuracy_m;
        state[accuracy] = {limit, kPolicyNow};
        EXPECT_FALSE(decide_on(state).terrain_degraded);
        state[accuracy] = {limit + 0.1, kPolicyNow};
        EXPECT_TRUE(decide_on(state).terrain_degraded);
        EXPECT_FALSE(decide_on(state).show_warning_colors);
        EXPECT_TRUE(has_flag(decide_on(state), std::string(to_string(accuracy)) + ".above_limit"));
    }
}

TEST(FailurePolicy, HeadingFallsBackFromTrueToMagneticToTrack) {
    AircraftState state = everything_valid();
    put_signal(state, Signal::true_heading, SignalState::lost);
    EXPECT_EQ(decide_on(state).view_heading, Signal::magnetic_heading);
    put_signal(state, Signal::magnetic_variation, SignalState::lost);
    EXPECT_EQ(decide_on(state).view_heading, Signal::true_track);
    EXPECT_EQ(decide_on(state)[Element::heading].source, Signal::magnetic_heading);  // shown, but cannot turn the view
    put_signal(state, Signal::magnetic_heading, SignalState::lost);
    const DisplayDecisions tracked = decide_on(state);
    EXPECT_EQ(tracked.view_heading, Signal::true_track);
    EXPECT_EQ(tracked[Element::heading].show, ElementShow::substituted);
    EXPECT_TRUE(tracked.show_terrain);
    EXPECT_TRUE(has_flag(tracked, "true_heading.lost"));
    put_signal(state, Signal::true_track, SignalState::stale);
    EXPECT_FALSE(decide_on(state).show_terrain);
    EXPECT_EQ(decide_on(state)[Element::heading].show, ElementShow::flagged);
}

TEST(FailurePolicy, TheDatabaseHasItsPictures) {
    const std::pair<TerrainSource, const char*> cases[] = {
        {TerrainSource::none, "NO TERRAIN DATA"},   {TerrainSource::outside, "OUTSIDE DATABASE"},
        {TerrainSource::failed, "TERRAIN FAIL"},    {TerrainSource::over_budget, "TERRAIN OFF"},
        {TerrainSource::too_coarse, "TERRAIN OFF"}, {TerrainSource::above_own_ship, "BELOW TERRAIN"}};
    for (const auto& [source, text] : cases) {
        DisplayConditions conditions = good_conditions();
        conditions.terrain = source;
        const DisplayDecisions decisions = decide_on(everything_valid(), conditions);
        EXPECT_FALSE(decisions.show_terrain);
        EXPECT_FALSE(decisions.show_warning_colors);
        EXPECT_TRUE(decisions.plain_horizon);
        EXPECT_TRUE(has_notice(decisions, text));
        EXPECT_EQ(decisions.flags.size(), 1u);
    }
}

TEST(FailurePolicy, APoseHasNoFailedSensors) {
    AircraftState pose = everything_valid();
    for (const Signal signal : {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed,
                                Signal::ground_speed, Signal::vertical_speed, Signal::baro_setting})
        put_signal(pose, signal, SignalState::missing);
    EXPECT_EQ(decide_on(pose)[Element::airspeed].show, ElementShow::failed) << "control: a flight";
    pose.is_posed = true;
    EXPECT_EQ(decide_on(pose)[Element::airspeed].show, ElementShow::absent);
    EXPECT_EQ(decide_on(pose)[Element::vertical_speed].show, ElementShow::absent);
    EXPECT_TRUE(decide_on(pose).flags.empty());
    put_signal(pose, Signal::pitch, SignalState::missing);
    EXPECT_EQ(decide_on(pose)[Element::attitude].show, ElementShow::failed) << "without it there is no view";
    EXPECT_FALSE(decide_on(pose).show_terrain);
}

NoticeLevel level_of(const DisplayDecisions& decisions, std::string_view text) {
    for (const Notice& notice : decisions.notices)
        if (notice.text.view() == text) return notice.level;
    ADD_FAILURE() << text << " is not said";
    return NoticeLevel::information;
}

TEST(FailurePolicy, BelowTerrainIsAWarningUnlessTheAircraftIsParked) {
    DisplayConditions conditions = good_conditions();
    conditions.terrain = TerrainSource::above_own_ship;
    AircraftState state = everything_valid();
    state[Signal::height_above_terrain] = {-3, kPolicyNow};
    EXPECT_EQ(level_of(decide_on(state, conditions), "BELOW TERRAIN"), NoticeLevel::warning);
    EXPECT_TRUE(decide_on(state, conditions).below_terrain);
    state.own_ship.velocity_north_mps = 2;
    EXPECT_EQ(level_of(decide_on(state, conditions), "BELOW TERRAIN"), NoticeLevel::caution) << "its height is a little off";
    EXPECT_FALSE(decide_on(state, conditions).below_terrain);
    state[Signal::height_above_terrain] = {-80, kPolicyNow};
    EXPECT_EQ(level_of(decide_on(state, conditions), "BELOW TERRAIN"), NoticeLevel::warning);
    EXPECT_FALSE(decide_on(state).below_terrain) << "control";
}

/// By a radio altimeter within a metre; by the database, which may err by more than a flare is high, in phases of the ground
/// alone.
TEST(FailurePolicy, OnTheGroundIsWhatItsSourceCanTell) {
    const auto on_ground = [](std::optional<double> radio_m, double terrain_m, flight::FlightPhase phase) {
        AircraftState state = everything_valid();
        put_signal(state, Signal::radio_height, SignalState::missing);
        if (radio_m) state[Signal::radio_height] = {*radio_m, kPolicyNow};
        state[Signal::height_above_terrain] = {terrain_m, kPolicyNow};
        DisplayConditions conditions = good_conditions();
        conditions.phase.phase = phase;
        return decide_on(state, conditions).is_on_ground;
    };
    constexpr flight::FlightPhase kCruise{flight::Scenario::cruise, 0}, kGround{flight::Scenario::ground, 0};
    for (const flight::FlightPhase phase : {flight::kApproachFinal, flight::kApproachLanding, kCruise, kGround}) {
        EXPECT_TRUE(on_ground(0.2, 7, phase));
        EXPECT_FALSE(on_ground(3, 0, phase)) << "in the flare";
    }
    for (const flight::FlightPhase phase : {kGround, flight::kTakeoffStart, flight::kApproachLanding}) {
        EXPECT_TRUE(on_ground(std::nullopt, 3, phase));
        EXPECT_FALSE(on_ground(std::nullopt, 6, phase));
    }
    for (const flight::FlightPhase phase : {flight::kApproachFinal, flight::kTakeoffFirstClimb, kCruise})
        for (const double terrain_m : {3.0, -20.0}) EXPECT_FALSE(on_ground(std::nullopt, terrain_m, phase)) << terrain_m;
}

TEST(FailurePolicy, TerrainAheadIsSaidFirstWhateverIsShownOfIt) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "TERRAIN AHEAD")) << "control";
    for (const TerrainAhead ahead : {TerrainAhead::caution, TerrainAhead::warning}) {
        conditions.terrain_ahead = ahead;
        for (const TerrainSource source : {TerrainSource::ready, TerrainSource::too_coarse, TerrainSource::over_budget})
            for (const bool is_map : {false, true})
                for (const double roll_deg : {0.0, 100.0}) {
                    conditions.terrain = source;
                    conditions.is_map = is_map;
                    AircraftState state = everything_valid();
                    state[Signal::roll] = {base::radians(roll_deg), kPolicyNow};
                    put_signal(state, Signal::true_heading, SignalState::lost);
                    const DisplayDecisions decisions = decide_on(state, conditions);
                    EXPECT_EQ(decisions.notices[0].text.view(), "TERRAIN AHEAD");
                    EXPECT_EQ(decisions.notices[0].level,
                              ahead == TerrainAhead::warning ? NoticeLevel::warning : NoticeLevel::caution);
                    EXPECT_TRUE(has_flag(decisions, "terrain.ahead"));
                }
    }
}

/// The more urgent first; of the same urgency terrain.
TEST(FailurePolicy, ObstacleAheadIsSaidBesideTerrainAhead) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "OBSTACLE AHEAD")) << "control";
    constexpr TerrainAhead kLevels[] = {TerrainAhead::none, TerrainAhead::caution, TerrainAhead::warning};
    for (const TerrainAhead terrain : kLevels)
        for (const TerrainAhead obstacle : {TerrainAhead::caution, TerrainAhead::warning}) {
            conditions.terrain_ahead = terrain;
            conditions.obstacle_ahead = obstacle;
            const DisplayDecisions decisions = decide_on(everything_valid(), conditions);
            const bool is_first = obstacle > terrain;
            EXPECT_EQ(decisions.notices[0].text.view(), is_first ? "OBSTACLE AHEAD" : "TERRAIN AHEAD");
            if (!is_first) EXPECT_EQ(decisions.notices[1].text.view(), "OBSTACLE AHEAD");
            EXPECT_EQ(level_of(decisions, "OBSTACLE AHEAD"),
                      obstacle == TerrainAhead::warning ? NoticeLevel::warning : NoticeLevel::caution);
            EXPECT_TRUE(has_flag(decisions, "obstacle.ahead"));
        }
}

TEST(FailurePolicy, TerrainAheadOfAnUncertainPlaceIsNotSaid) {
    DisplayConditions conditions = good_conditions();
    conditions.terrain_ahead = conditions.obstacle_ahead = TerrainAhead::warning;
    AircraftState lost = everything_valid(), inaccurate = lost, barometric = lost;
    lost.own_ship.state = SignalState::lost;
    inaccurate[Signal::vertical_accuracy] = {5000, kPolicyNow};
    barometric.own_ship.height_is_geometric = false;
    put_signal(barometric, Signal::baro_setting, SignalState::lost);
    for (const AircraftState& state : {lost, inaccurate, barometric}) {
        EXPECT_FALSE(has_notice(decide_on(state, conditions), "TERRAIN AHEAD"));
        EXPECT_FALSE(has_flag(decide_on(state, conditions), "terrain.ahead"));
        EXPECT_FALSE(has_notice(decide_on(state, conditions), "OBSTACLE AHEAD"));
    }
    for (const TerrainSource source : {TerrainSource::none, TerrainSource::failed}) {
        conditions.terrain = source;
        EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "TERRAIN AHEAD"));
    }
}

TEST(FailurePolicy, UnusualAttitudesDeclutter) {
    const std::pair<double, double> unusual[] = {{31, 0}, {-21, 0}, {0, 61}, {0, -61}, {0, 179}};
    for (const auto& [pitch_deg, roll_deg] : unusual) {
        AircraftState state = everything_valid();
        state[Signal::pitch] = {base::radians(pitch_deg), kPolicyNow};
        state[Signal::roll] = {base::radians(roll_deg), kPolicyNow};
        EXPECT_TRUE(decide_on(state).unusual_attitude);
        EXPECT_TRUE(has_flag(decide_on(state), "attitude.unusual"));
        EXPECT_FALSE(decide_on(state).show_warning_colors);
        EXPECT_EQ(decide_on(state)[Element::flight_path].show, ElementShow::absent);
    }
    AircraftState steep = everything_valid();
    steep[Signal::pitch] = {base::radians(29), kPolicyNow};
    steep[Signal::roll] = {base::radians(-59), kPolicyNow};
    EXPECT_FALSE(decide_on(steep).unusual_attitude);
    EXPECT_FALSE(has_flag(decide_on(steep), "attitude.unusual"));
}

TEST(FailurePolicy, AnUnusualAttitudeEndsWellWithinItsLimit) {
    const auto unusual_at = [](double pitch_deg, double up_to_deg) {
        AircraftState state = everything_valid();
        state.excursion.step(base::radians(up_to_deg), 0);
        state[Signal::pitch] = {base::radians(pitch_deg), kPolicyNow};
        return decide_on(state).unusual_attitude;
    };
    EXPECT_TRUE(unusual_at(28, 31)) << "it was beyond 30 degrees, and is not yet within 25";
    EXPECT_FALSE(unusual_at(24, 31));
    EXPECT_FALSE(unusual_at(28, 29)) << "it was never beyond";
    EXPECT_TRUE(unusual_at(-17, -21));
    EXPECT_FALSE(unusual_at(-14, -21));
}

TEST(FailurePolicy, WhatIsNoPilotsViewIsSaid) {
    design::DesignSettings design = design::default_design_settings();
    const auto decide = [&](const DisplayConditions& conditions) {
        return decide_display(everything_valid(), kPolicyNow, conditions, design);
    };
    EXPECT_FALSE(has_notice(decide(map_conditions()), "ORTHOGRAPHIC VIEW"));
    EXPECT_FALSE(has_flag(decide(map_conditions()), "terrain.flat"));
    design.view.mode = design::ViewMode::orthographic;
    EXPECT_TRUE(has_notice(decide(map_conditions()), "ORTHOGRAPHIC VIEW"));
    EXPECT_FALSE(has_notice(decide(map_conditions()), "FLAT - NO RELIEF"));
    design.view.reference = design::Reference::flat;
    EXPECT_TRUE(has_notice(decide(map_conditions()), "FLAT - NO RELIEF"));
    EXPECT_TRUE(has_flag(decide(map_conditions()), "terrain.flat"));
    DisplayConditions without = map_conditions();
    without.terrain = TerrainSource::failed;
    EXPECT_FALSE(has_notice(decide(without), "FLAT - NO RELIEF")) << "there is no ground at all";
}

TEST(FailurePolicy, TrafficThatIsLeftOutIsSaid) {
    flight::AircraftState state = everything_valid();
    state.traffic.is_received = true;
    EXPECT_FALSE(has_notice(decide_on(state), "TRAFFIC INCOMPLETE"));
    state.traffic.is_cut = true;
    EXPECT_TRUE(has_notice(decide_on(state), "TRAFFIC INCOMPLETE"));
    EXPECT_TRUE(has_flag(decide_on(state), "traffic.cut"));
}

/// An empty sky must not be taken for a clear one.
TEST(FailurePolicy, DataThatAreNoLongerValidAreSaidToBeMissing) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "DATA OUT OF DATE"));
    conditions.data_are_out_of_date = true;
    EXPECT_TRUE(has_notice(decide_on(everything_valid(), conditions), "DATA OUT OF DATE"));
    EXPECT_TRUE(has_flag(decide_on(everything_valid(), conditions), "data.out_of_date"));
    conditions.terrain = TerrainSource::failed;
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "DATA OUT OF DATE")) << "no data are shown at all";
}

/// Whatever is shown of them; nothing is removed.
TEST(FailurePolicy, DatabasesThatMayNotBeUsedAreSaid) {
    for (const TerrainSource terrain : {TerrainSource::ready, TerrainSource::none, TerrainSource::failed}) {
        DisplayConditions conditions = good_conditions();
        conditions.terrain = terrain;
        const DisplayDecisions current = decide_on(everything_valid(), conditions);
        EXPECT_FALSE(has_flag(current, "database.out_of_date"));
        conditions.databases = base::Currency::expired;
        const DisplayDecisions expired = decide_on(everything_valid(), conditions);
        conditions.databases = base::Currency::not_yet_valid;
        const DisplayDecisions early = decide_on(everything_valid(), conditions);
        EXPECT_TRUE(has_notice(expired, "DATABASE EXPIRED") && !has_notice(expired, "DATABASE NOT YET VALID"));
        EXPECT_TRUE(has_notice(early, "DATABASE NOT YET VALID") && !has_notice(early, "DATABASE EXPIRED"));
        for (const DisplayDecisions& decisions : {expired, early}) {
            EXPECT_TRUE(has_flag(decisions, "database.out_of_date"));
            EXPECT_EQ(decisions.show_terrain, current.show_terrain);
            EXPECT_EQ(decisions.show_warning_colors, current.show_warning_colors);
            EXPECT_EQ(decisions.notices.size(), current.notices.size() + 1);
            EXPECT_EQ(decisions.flags.size(), current.flags.size() + 1);
        }
    }
}

/// Whatever the legend shows.
TEST(FailurePolicy, StaleDataAreSaidToBeStale) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "DATA STALE"));
    conditions.data_are_stale = true;
    EXPECT_TRUE(has_notice(decide_on(everything_valid(), conditions), "DATA STALE"));
    EXPECT_TRUE(has_flag(decide_on(everything_valid(), conditions), "data.stale"));
    conditions.terrain = TerrainSource::failed;
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "DATA STALE")) << "no data are shown at all";
}

TEST(FailurePolicy, AReducedPictureIsSaidWhereAskedFor) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "GRAPHICS REDUCED"));
    conditions.is_reduced = true;
    EXPECT_TRUE(has_notice(decide_on(everything_valid(), conditions), "GRAPHICS REDUCED"));
}

/// Its heat changes the colours of warnings too.
TEST(FailurePolicy, AMeasureOverThePictureIsSaidWhereItIsShown) {
    DisplayConditions conditions = good_conditions();
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "ANALYSIS OVERLAY"));
    conditions.shows_measure = true;
    EXPECT_TRUE(has_notice(decide_on(everything_valid(), conditions), "ANALYSIS OVERLAY"));
    AircraftState steep = everything_valid();
    steep[Signal::pitch] = {base::radians(40), kPolicyNow};
    EXPECT_FALSE(has_notice(decide_on(steep, conditions), "ANALYSIS OVERLAY")) << "the recovery picture";
    conditions.terrain = TerrainSource::failed;
    EXPECT_FALSE(has_notice(decide_on(everything_valid(), conditions), "ANALYSIS OVERLAY"));
}

TEST(FailurePolicy, PhaseFaultsAndGeneratedFlightsAreSaid) {
    DisplayConditions conditions = good_conditions();
    conditions.phase.switch_fault = true;
    conditions.phase.disagreement = true;
    conditions.generated_flight = true;
    const DisplayDecisions decisions = decide_on(everything_valid(), conditions);
    EXPECT_TRUE(has_flag(decisions, "phase.switch_fault"));
    EXPECT_TRUE(has_flag(decisions, "phase.disagreement"));
    EXPECT_TRUE(has_notice(decisions, "GENERATED FLIGHT"));
    for (std::size_t i = 1; i < decisions.notices.size(); ++i)
        EXPECT_GE(decisions.notices[i].level, decisions.notices[i - 1].level);
}

TEST(FailurePolicy, NoMixOfStatesOverflowsOrShowsTerrainOnBadAttitude) {
    // Every signal drawn from a small deterministic generator; a full container would stop the program.
    std::uint32_t random = 1;
    for (int round = 0; round < 20'000; ++round) {
        AircraftState state = everything_valid();
        state.traffic.is_cut = true;
        for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
            random = random * 1664525u + 1013904223u;
            put_signal(state, static_cast<Signal>(i), static_cast<SignalState>((random >> 16) % 5));
        }
        random = random * 1664525u + 1013904223u;
        state.own_ship.state = static_cast<SignalState>((random >> 16) % 5);
        DisplayConditions conditions = good_conditions();
        conditions.terrain = static_cast<TerrainSource>((random >> 20) % 4);
        conditions.phase.switch_fault = conditions.phase.disagreement = conditions.generated_flight = true;
        conditions.terrain_is_coarse = conditions.terrain_ends = conditions.image_is_missing = conditions.data_are_out_of_date =
            conditions.is_reduced = conditions.shows_measure = true;
        conditions.databases = base::Currency::expired;
        const DisplayDecisions decisions = decide_on(state, conditions);
        const bool known = state.is_valid(Signal::pitch, kPolicyNow) && state.is_valid(Signal::roll, kPolicyNow) &&
                           state.own_ship.state == SignalState::valid && decisions.view_heading != Signal::count_;
        EXPECT_TRUE(known || !decisions.show_terrain);
        EXPECT_TRUE(!decisions.show_warning_colors || (decisions.show_terrain && !decisions.terrain_degraded));
        EXPECT_FALSE(decisions.show_terrain && decisions.plain_horizon);
    }
}

}  // namespace
}  // namespace tedavis::policy::test_failure_policy
