#include "render_core/flight/motion_phase_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/render_core/flight/scripted_motion.hpp"

namespace tedavis::flight::test_motion_phase_detector {
namespace {

using namespace scripted_motion;

TEST(MotionPhaseDetector, a_whole_flight_passes_through_every_phase_once) { EXPECT_EQ(fly({kWholeFlight}), kWholeFlightPhases); }

TEST(MotionPhaseDetector, heights_from_the_terrain_database_do_as_well) {
    Script script{kWholeFlight};
    script.height_from = HeightFrom::terrain;
    EXPECT_EQ(fly(script), kWholeFlightPhases);
}

TEST(MotionPhaseDetector, the_step_may_be_anything_up_to_the_longest) {
    for (const double step : {0.02, 0.05, 0.3, 1.0, 1.9}) {
        Script script{kWholeFlight};
        script.step = [step](double) { return step; };
        EXPECT_EQ(fly(script), kWholeFlightPhases) << step;
    }
    Script uneven{kWholeFlight};
    uneven.step = [](double t) { return 0.02 + std::abs(std::sin(t * 7.3)); };
    EXPECT_EQ(fly(uneven), kWholeFlightPhases);
}

TEST(MotionPhaseDetector, turbulence_makes_no_flicker) {
    for (const double noise : {0.5, 1.5, 2.5}) {
        Script script{kWholeFlight};
        script.vertical_noise = noise;
        EXPECT_EQ(fly(script), kWholeFlightPhases) << noise;
    }
}

TEST(MotionPhaseDetector, a_go_around_is_followed_by_replanning_and_another_approach) {
    const auto legs =
        joined({kToCruise,
                kDownToFinal,
                {{20, -3, 50}, {60, 7, 70}, {60, 0, 70}, {60, -4, 60}, {80, -3, 50}, {70, -1, 45}, {60, 0, 5}, {30, 0, 0}}});
    const std::vector<std::string> expected = {"ground",
                                               "takeoff.start",
                                               "takeoff.first_climb",
                                               "takeoff.second_climb",
                                               "cruise",
                                               "approach.descent",
                                               "approach.initial",
                                               "approach.final",
                                               "go_around.abort",
                                               "go_around.replanning",
                                               "approach.initial",
                                               "approach.final",
                                               "approach.landing",
                                               "ground"};
    EXPECT_EQ(fly({legs}), expected);
}

TEST(MotionPhaseDetector, a_bump_on_final_is_no_go_around) {
    const auto legs = joined({kToCruise, kDownToFinal, {{20, -3, 50}, {4, 5, 50}, {60, -3, 45}, {20, 0, 5}, {30, 0, 0}}});
    const auto phases = fly({legs});
    EXPECT_EQ(phases, kWholeFlightPhases) << "4 s at 5 m/s gain less than 30 m";
}

TEST(MotionPhaseDetector, a_slow_climb_on_final_is_no_go_around_before_it_has_gained_30_m) {
    const auto climb_for = [](double seconds) {
        return fly({joined({kToCruise, kDownToFinal, {{20, -3, 50}, {seconds, 2.8, 50}, {3, -3, 45}}})}).back();
    };
    EXPECT_EQ(climb_for(13), "approach.final") << "fast enough for long enough, but not high enough";
    EXPECT_EQ(climb_for(25), "go_around.abort");
}

TEST(MotionPhaseDetector, level_flight_may_wander_a_little_further_than_it_began) {
    const auto after = [](double first, double then) {
        MotionPhaseState state;
        base::Time now{kMotionStart};
        static_cast<void>(go_on(state, now, 10, kNoChange, {150, first, 3000, 0}));
        return name_of(go_on(state, now, 40, kNoChange, {150, then, 3000, 0}));
    };
    EXPECT_EQ(after(0, 1.7), "cruise");
    EXPECT_EQ(after(0, 2.1), "-");
    EXPECT_EQ(after(1.7, 1.7), "-");
}

TEST(MotionPhaseDetector, a_rejected_takeoff_returns_to_ground) {
    EXPECT_EQ(fly({{{20, 0, 0}, {20, 0, 40}, {20, 0, 2}, {20, 0, 2}}}),
              (std::vector<std::string>{"ground", "takeoff.start", "ground"}));
}

TEST(MotionPhaseDetector, fast_taxiing_is_no_takeoff) {
    EXPECT_EQ(fly({{{20, 0, 0}, {60, 0, 14}, {60, 0, 0}}}), std::vector<std::string>{"ground"});
}

TEST(MotionPhaseDetector, a_step_climb_stays_in_cruise) {
    const auto legs = joined({kToCruise, {{60, 3, 150}, {120, 0, 150}}});
    EXPECT_EQ(fly({legs}).back(), "cruise");
    const auto again = joined({kToCruise, {{8, -4, 150}, {120, 0, 150}}});
    EXPECT_EQ(fly({again}).back(), "cruise") << "eight seconds of descent are none";
}

TEST(MotionPhaseDetector, levelling_off_high_up_leaves_the_descent_for_cruise) {
    const auto legs = joined({kToCruise, {{60, -5, 150}, {120, 0, 150}}});
    const auto phases = fly({legs});
    EXPECT_EQ(phases[phases.size() - 2], "approach.descent");
    EXPECT_EQ(phases.back(), "cruise");
}

TEST(MotionPhaseDetector, a_climb_that_is_level_below_the_height_of_cruise_has_ended_until_it_goes_on) {
    const std::vector<Leg> to_630_m = {{20, 0, 0}, {25, 0, 60}, {30, 6, 80}, {50, 9, 80}};
    const auto last_after = [&](std::vector<Leg> more) {
        MotionPhaseState state;
        (void)fly({joined({to_630_m, more})}, state);
        return state.stage;
    };
    EXPECT_EQ(last_after({}), MotionStage::second_climb);
    EXPECT_EQ(last_after({{8, 0, 80}}), MotionStage::second_climb) << "eight seconds prove nothing";
    EXPECT_EQ(last_after({{30, 0, 80}}), MotionStage::low_flight);
    EXPECT_EQ(fly({joined({to_630_m, {{30, 0, 80}}})}).back(), "unknown") << "level at 630 m may be anything";
    EXPECT_EQ(last_after({{30, 0, 80}, {30, 6, 80}}), MotionStage::second_climb);
    EXPECT_EQ(last_after({{30, 0, 80}, {60, -4, 70}}), MotionStage::initial) << "as from any height";
}

TEST(MotionPhaseDetector, a_go_around_that_is_level_in_the_circuit_has_ended) {
    const std::vector<Leg> to_final = joined({kToCruise, kDownToFinal});
    const auto phases = fly({joined({to_final, {{40, 4, 60}, {30, 0, 60}, {13, -2, 58}}})});
    ASSERT_GE(phases.size(), 3u);
    EXPECT_EQ(phases[phases.size() - 3], "go_around.abort");
    EXPECT_EQ(phases[phases.size() - 2], "unknown") << "level at 340 m may be anything";
    EXPECT_EQ(phases.back(), "approach.initial");
}

TEST(MotionPhaseDetector, finds_its_place_in_the_middle_of_a_flight) {
    const auto begun_at = [](double height, double vertical_speed) {
        MotionPhaseState state;
        PhaseStatement found;
        for (int i = 0; i < 400; ++i) {
            const base::Time now{kMotionStart + i * 100'000'000LL};
            const Sample s{90, vertical_speed, height + 0.1 * i * vertical_speed, 0};
            found = detect_motion_phase(aircraft_at(s, now, HeightFrom::terrain), now, {}, state);
        }
        return name_of(found);
    };
    EXPECT_EQ(begun_at(3000, 0), "cruise");
    EXPECT_EQ(begun_at(3000, -6), "approach.descent");
    EXPECT_EQ(begun_at(800, -3), "approach.initial");
    EXPECT_EQ(begun_at(1000, 6), "takeoff.second_climb");
    EXPECT_EQ(begun_at(100, 2), "takeoff.first_climb");
    EXPECT_EQ(begun_at(3000, 2), "-") << "a slow climb high up may be part of a cruise";
    EXPECT_EQ(begun_at(600, 0), "-") << "level at 600 m may be anything";
}

TEST(MotionPhaseDetector, motion_that_is_not_asked_for_states_nothing) {
    MotionPhaseState state;
    MotionPhaseSettings settings;
    settings.is_enabled = false;
    const base::Time now{kMotionStart};
    EXPECT_FALSE(detect_motion_phase(aircraft_at({0, 0, 0, 0}, now, HeightFrom::radio), now, settings, state).stated);
    EXPECT_FALSE(state.any_update);
}

TEST(MotionPhaseDetector, terrain_that_rises_below_a_cruise_ends_it) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const Sample low{150, 0, 400, 0};
    EXPECT_EQ(name_of(go_on(state, now, 1.5, kNoChange, low)), "unknown") << "which shows terrain";
    EXPECT_EQ(name_of(go_on(state, now, 60, kNoChange, {150, 0, 800, 0})), "unknown") << "and cruise needs far more height again";
    EXPECT_EQ(name_of(go_on(state, now, 31, kNoChange, {150, 0, 1600, 0})), "cruise");
}

TEST(MotionPhaseDetector, no_settings_take_priority_from_terrain_below_1500_ft) {
    MotionPhaseSettings reckless;
    reckless.cruise_height_m = 0;
    reckless.replanning_height_m = 0;
    MotionPhaseState state;
    for (int i = 0; i < 3000; ++i) {
        const base::Time now{kMotionStart + i * 100'000'000LL};
        const Sample s{80, 0, 450, 0};
        const PhaseStatement found = detect_motion_phase(aircraft_at(s, now, HeightFrom::terrain), now, reckless, state);
        ASSERT_FALSE(found.stated && prioritized_aspect(found.phase) != Aspect::terrain);
    }
    const base::Time later{kMotionStart + 3000 * 100'000'000LL};
    const Sample higher{80, 0, 460, 0};
    EXPECT_EQ(name_of(detect_motion_phase(aircraft_at(higher, later, HeightFrom::terrain), later, reckless, state)), "cruise")
        << "ten metres higher the same settings do state cruise";
}

TEST(MotionPhaseDetector, the_lower_of_two_heights_guards_terrain) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const auto radio_says_low = [&](AircraftState& a) { a[Signal::radio_height] = {300, now}; };
    EXPECT_EQ(name_of(go_on(state, now, 2, radio_says_low)), "unknown");
    state = cruising(now);
    const auto terrain_is_lower = [&](AircraftState& a) {
        a[Signal::radio_height] = {600, now};
        a[Signal::height_above_terrain] = {300, now};
    };
    EXPECT_EQ(name_of(go_on(state, now, 2, terrain_is_lower)), "unknown");
    state = cruising(now);
    const auto radio_out_of_range = [&](AircraftState& a) { a[Signal::radio_height] = {760, now}; };
    EXPECT_EQ(name_of(go_on(state, now, 2, radio_out_of_range)), "cruise");
}

TEST(MotionPhaseDetector, a_long_step_proves_nothing) {
    MotionPhaseState state;
    PhaseStatement found;
    for (int i = 0; i < 40; ++i) {
        const base::Time now{kMotionStart + i * 5'000'000'000LL};
        found = detect_motion_phase(aircraft_at({150, 0, 3000, 0}, now, HeightFrom::terrain), now, {}, state);
    }
    EXPECT_FALSE(found.stated) << "5 s between updates: nobody knows what happened between them";
}

TEST(MotionPhaseDetector, asking_twice_at_one_instant_changes_nothing) {
    MotionPhaseState once, twice;
    for (int i = 0; i < 1000; ++i) {
        const base::Time now{kMotionStart + i * 100'000'000LL};
        const AircraftState a = aircraft_at(sample_at(kWholeFlight, 0.1 * i), now, HeightFrom::radio);
        const PhaseStatement one = detect_motion_phase(a, now, {}, once);
        static_cast<void>(detect_motion_phase(a, now, {}, twice));
        const PhaseStatement two = detect_motion_phase(a, now, {}, twice);
        ASSERT_EQ(name_of(one), name_of(two));
    }
}

TEST(MotionPhaseDetector, time_that_runs_back_starts_anew_and_a_saved_state_goes_on) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const MotionPhaseState saved = state;
    base::Time earlier = now - base::Duration::seconds(100);
    EXPECT_FALSE(go_on(state, earlier, 1, kNoChange).stated);
    state = saved;
    EXPECT_EQ(name_of(go_on(state, now, 1, kNoChange)), "cruise");
}

}  // namespace
}  // namespace tedavis::flight::test_motion_phase_detector
