#include "render_core/flight/motion_phase_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "render_core/flight/phase_statement.hpp"

namespace tedavis::flight::test_motion_phase_detector {
namespace {

constexpr std::int64_t kStart = 1'700'000'000'000'000'000;

std::string name_of(PhaseStatement statement) {
    if (!statement.stated) return "-";
    const std::string sub_phase = sub_phase_name(statement.phase);
    return scenario_name(statement.phase) + (sub_phase.empty() ? "" : "." + sub_phase);
}

/// A stretch of flight at constant vertical speed, ground speed changing evenly to its end.
struct Leg {
    double seconds;
    double vertical_speed;
    double end_speed;
};

struct Sample {
    double ground_speed = 0;
    double vertical_speed = 0;
    double height = 0;
    double acceleration = 0;
};

/// The exact motion at `t`, computed from the legs and never by accumulation; height stops at the ground.
Sample sample_at(const std::vector<Leg>& legs, double t) {
    Sample s;
    for (const Leg& leg : legs) {
        const double in_leg = std::min(t, leg.seconds);
        s.acceleration = (leg.end_speed - s.ground_speed) / leg.seconds;
        s.height = std::max(0.0, s.height + leg.vertical_speed * in_leg);
        s.vertical_speed = s.height > 0 ? leg.vertical_speed : 0;
        if (t <= leg.seconds) {
            s.ground_speed += s.acceleration * t;
            return s;
        }
        s.ground_speed = leg.end_speed;
        t -= leg.seconds;
    }
    return s;
}

double length_of(const std::vector<Leg>& legs) {
    double seconds = 0;
    for (const Leg& leg : legs) seconds += leg.seconds;
    return seconds;
}

void put(AircraftState& aircraft, Signal signal, double value, base::Time at) { aircraft[signal] = {value, at}; }

enum class HeightFrom { radio, terrain };

AircraftState aircraft_at(const Sample& s, base::Time now, HeightFrom height_from) {
    AircraftState aircraft;
    put(aircraft, Signal::ground_speed, s.ground_speed, now);
    put(aircraft, Signal::vertical_speed, s.vertical_speed, now);
    put(aircraft, Signal::longitudinal_acceleration, s.acceleration, now);
    if (height_from == HeightFrom::radio) put(aircraft, Signal::radio_height, s.height, now);
    put(aircraft, Signal::height_above_terrain, s.height, now);
    return aircraft;
}

struct Script {
    std::vector<Leg> legs;
    std::function<double(double)> step = [](double) { return 0.1; };  // seconds, by time
    double vertical_noise = 0;
    HeightFrom height_from = HeightFrom::radio;
};

/// The distinct statements in order, "-" left out.
std::vector<std::string> fly(const Script& script, MotionPhaseState& state) {
    std::vector<std::string> phases;
    std::mt19937_64 random(77);
    std::uniform_real_distribution<double> noise(-script.vertical_noise, script.vertical_noise);
    const MotionPhaseSettings settings;
    for (double t = 0; t < length_of(script.legs); t += script.step(t)) {
        const base::Time now{kStart + std::llround(t * 1e9)};
        Sample s = sample_at(script.legs, t);
        s.vertical_speed += noise(random);
        const PhaseStatement found = detect_motion_phase(aircraft_at(s, now, script.height_from), now, settings, state);
        const std::string name = name_of(found);
        if (found.stated && (phases.empty() || phases.back() != name)) phases.push_back(name);
        const bool takes_priority = found.stated && prioritized_aspect(found.phase) != Aspect::terrain;
        EXPECT_FALSE(takes_priority && s.height < settings.terrain_priority_height_m - 10) << name << " at " << s.height << " m";
    }
    return phases;
}

std::vector<std::string> fly(const Script& script) {
    MotionPhaseState state;
    return fly(script, state);
}

const std::vector<Leg> kToCruise = {{20, 0, 0}, {25, 0, 60}, {60, 6, 80}, {200, 9, 120}, {120, 0, 150}};
const std::vector<Leg> kDownToFinal = {{260, -5, 90}, {80, -4, 70}, {90, -4, 60}};

std::vector<Leg> joined(std::initializer_list<std::vector<Leg>> parts) {
    std::vector<Leg> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

PhaseStatement go_on(MotionPhaseState& state, base::Time& now, double seconds, const std::function<void(AircraftState&)>& change,
                     Sample s = {150, 0, 2160, 0}) {
    PhaseStatement found;
    for (double t = 0; t < seconds; t += 0.1) {
        now = now + base::Duration::milliseconds(100);
        AircraftState aircraft = aircraft_at(s, now, HeightFrom::terrain);
        change(aircraft);
        found = detect_motion_phase(aircraft, now, {}, state);
    }
    return found;
}
const auto kNoChange = [](AircraftState&) {};

/// Ground to cruise (2160 m), down to 180 m, land, stop.
const std::vector<Leg> kWholeFlight = joined({kToCruise, kDownToFinal, {{60, -3, 50}, {5, -0.5, 45}, {40, 0, 5}, {30, 0, 5}}});
const std::vector<std::string> kWholeFlightPhases = {
    "ground",           "takeoff.start",    "takeoff.first_climb", "takeoff.second_climb", "cruise",
    "approach.descent", "approach.initial", "approach.final",      "approach.landing",     "ground"};

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
        base::Time now{kStart};
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
            const base::Time now{kStart + i * 100'000'000LL};
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

/// In cruise at 2160 m; the state from there on.
MotionPhaseState cruising(base::Time& now) {
    MotionPhaseState state;
    static_cast<void>(fly({kToCruise}, state));
    EXPECT_EQ(state.stage, MotionStage::cruise);
    now = state.last_update;
    return state;
}

TEST(MotionPhaseDetector, a_missing_speed_gives_no_statement) {
    for (const Signal signal : {Signal::ground_speed, Signal::vertical_speed}) {
        base::Time now;
        MotionPhaseState state = cruising(now);
        EXPECT_FALSE(go_on(state, now, 1, [&](AircraftState& a) { a[signal] = {}; }).stated) << to_string(signal);
        EXPECT_EQ(name_of(go_on(state, now, 1, kNoChange)), "cruise") << "a short gap forgets nothing";
        EXPECT_FALSE(go_on(state, now, 11, [&](AircraftState& a) { a[signal] = {}; }).stated);
        EXPECT_FALSE(go_on(state, now, 1, kNoChange).stated) << "after a long gap the phase is found anew";
        EXPECT_EQ(name_of(go_on(state, now, 31, kNoChange)), "cruise");
    }
}

TEST(MotionPhaseDetector, a_missing_height_gives_no_statement_for_ten_seconds) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const auto without = [](AircraftState& a) { a[Signal::height_above_terrain] = {}; };
    EXPECT_FALSE(go_on(state, now, 1, without).stated);
    EXPECT_EQ(name_of(go_on(state, now, 1, kNoChange)), "cruise");
    EXPECT_FALSE(go_on(state, now, 9.9, without).stated);
    EXPECT_EQ(name_of(go_on(state, now, 0.3, without)), "cruise") << "from then on it goes on without one";
    EXPECT_EQ(name_of(go_on(state, now, 15, without, {150, -5, 0, 0})), "approach.descent");
    EXPECT_EQ(name_of(go_on(state, now, 190, without, {150, 0, 0, 0})), "cruise");
    EXPECT_EQ(name_of(go_on(state, now, 1.5, kNoChange, {150, 0, 400, 0})), "unknown") << "low over ground that is known again";
}

/// Height above the place of the departure is that of the pressure altitude.
TEST(MotionPhaseDetector, without_a_height_a_flight_is_told_by_speed_climb_and_altitude) {
    MotionPhaseState state;
    std::vector<std::string> phases;
    for (double t = 0; t < length_of(kWholeFlight); t += 0.1) {
        const base::Time now{kStart + std::llround(t * 1e9)};
        const Sample s = sample_at(kWholeFlight, t);
        AircraftState aircraft = aircraft_at(s, now, HeightFrom::radio);
        aircraft[Signal::radio_height] = aircraft[Signal::height_above_terrain] = {};
        put(aircraft, Signal::standard_altitude, 700 + s.height, now);
        const PhaseStatement found = detect_motion_phase(aircraft, now, {}, state);
        if (found.stated && (phases.empty() || phases.back() != name_of(found))) phases.push_back(name_of(found));
    }
    const std::vector<std::string> expected = {
        "ground", "takeoff.start", "takeoff.first_climb", "takeoff.second_climb", "cruise", "approach.descent", "ground"};
    EXPECT_EQ(phases, expected);
}

TEST(MotionPhaseDetector, motion_that_is_not_asked_for_states_nothing) {
    MotionPhaseState state;
    MotionPhaseSettings settings;
    settings.is_enabled = false;
    const base::Time now{kStart};
    EXPECT_FALSE(detect_motion_phase(aircraft_at({0, 0, 0, 0}, now, HeightFrom::radio), now, settings, state).stated);
    EXPECT_FALSE(state.any_update);
}

/// Launch, thermals of two minutes with glides between them, a landing: climbs at 3 m/s, sinks at 1.5 m/s.
TEST(MotionPhaseDetector, a_glider_that_circles_in_thermals_is_in_cruise) {
    std::vector<Leg> legs = {{30, 0, 0}, {10, 0, 22}, {100, 7, 28}};
    for (int n = 0; n < 6; ++n) legs.insert(legs.end(), {{120, 3, 25}, {200, -1.5, 32}});
    legs.insert(legs.end(), {{800, -1.5, 30}, {60, 0, 1}, {140, 0, 0}});
    const auto phases = [&](AircraftClass aircraft, bool has_height) {
        MotionPhaseState state;
        std::vector<std::string> found;
        for (double t = 0; t < length_of(legs); t += 0.1) {
            const base::Time now{kStart + std::llround(t * 1e9)};
            const Sample s = sample_at(legs, t);
            AircraftState a = aircraft_at(s, now, HeightFrom::terrain);
            put(a, Signal::standard_altitude, 400 + s.height, now);
            if (!has_height) a[Signal::height_above_terrain] = {};
            const PhaseStatement stated = detect_motion_phase(a, now, motion_phase_settings(aircraft), state);
            if (stated.stated && (found.empty() || found.back() != name_of(stated))) found.push_back(name_of(stated));
        }
        return found;
    };
    const std::vector<std::string> whole = {"ground",           "takeoff.start", "takeoff.first_climb", "takeoff.second_climb",
                                            "cruise",           "unknown",       "approach.initial",    "approach.final",
                                            "approach.landing", "ground"};
    EXPECT_EQ(phases(AircraftClass::glider, true), whole) << "unknown: terrain keeps its priority below 1500 ft";
    const std::vector<std::string> without = {"ground", "takeoff.start", "takeoff.first_climb", "takeoff.second_climb",
                                              "cruise", "ground"};
    EXPECT_EQ(phases(AircraftClass::glider, false), without);
    EXPECT_GT(phases(AircraftClass::unstated, true).size(), whole.size()) << "control: as a powered aircraft it climbs anew";
}

/// A flight by legs from an altitude on, of which heights are known in some seconds only.
struct BlindFlight {
    AircraftClass aircraft = AircraftClass::light;
    std::vector<Leg> legs;
    double height_m = 0;  ///< above ground at the beginning
    std::function<bool(double)> has_height = [](double) { return false; };
    std::function<void(AircraftState&, base::Time)> change = [](AircraftState&, base::Time) {};

    /// Distinct statements in order; a gap without one is "-".
    [[nodiscard]] std::vector<std::string> phases() const {
        MotionPhaseState state;
        std::vector<std::string> found;
        for (double t = 0; t < length_of(legs); t += 0.1) {
            const base::Time now{kStart + std::llround(t * 1e9)};
            Sample s = sample_at(legs, t);
            s.height = height_m + risen_at(t);
            s.vertical_speed = s.height > 0 ? rate_at(t) : 0;
            s.height = std::max(s.height, 0.0);
            AircraftState a = aircraft_at(s, now, HeightFrom::terrain);
            put(a, Signal::standard_altitude, 500 + s.height, now);
            if (!has_height(t)) a[Signal::height_above_terrain] = {};
            change(a, now);
            const std::string name = name_of(detect_motion_phase(a, now, motion_phase_settings(aircraft), state));
            if (found.empty() || found.back() != name) found.push_back(name);
        }
        return found;
    }
    [[nodiscard]] double risen_at(double t) const {
        double risen_m = 0;
        for (const Leg& leg : legs) {
            risen_m += leg.vertical_speed * std::min(t, leg.seconds);
            t -= std::min(t, leg.seconds);
        }
        return risen_m;
    }
    [[nodiscard]] double rate_at(double t) const {
        for (const Leg& leg : legs) {
            if (t <= leg.seconds) return leg.vertical_speed;
            t -= leg.seconds;
        }
        return 0;
    }
};

bool has(const std::vector<std::string>& phases, const std::string& name) {
    return std::find(phases.begin(), phases.end(), name) != phases.end();
}

TEST(MotionPhaseDetector, who_leaves_the_database_low_is_not_in_cruise_before_the_ground_is_forgotten) {
    for (const AircraftClass aircraft :
         {AircraftClass::light, AircraftClass::helicopter, AircraftClass::glider, AircraftClass::unstated}) {
        BlindFlight flight{aircraft, {{0.1, 0, 60}, {500, 0, 60}}, 300, [](double t) { return t < 60; }};
        EXPECT_FALSE(has(flight.phases(), "cruise")) << static_cast<int>(aircraft);
        flight.legs = {{0.1, 0, 60}, {900, 0, 60}};
        EXPECT_TRUE(has(flight.phases(), "cruise")) << "ten minutes later nobody knows what is below";
    }
    BlindFlight climbs{
        AircraftClass::light, {{0.1, 0, 60}, {100, 0, 60}, {100, 6, 60}, {100, 0, 60}}, 300, [](double t) { return t < 60; }};
    EXPECT_EQ(climbs.phases().back(), "cruise") << "500 m above the last ground that was known";
}

TEST(MotionPhaseDetector, level_flight_low_above_the_departure_is_no_cruise) {
    const std::vector<Leg> circuit = {{30, 0, 0}, {25, 0, 60}, {55, 6, 60}, {300, 0, 60}};
    for (const AircraftClass aircraft : {AircraftClass::light, AircraftClass::jet, AircraftClass::unstated})
        EXPECT_FALSE(has(BlindFlight{aircraft, circuit}.phases(), "cruise")) << static_cast<int>(aircraft);
}

/// The departure is still known after the altitude was missing for some seconds.
TEST(MotionPhaseDetector, a_gap_of_the_altitude_does_not_lose_the_departure) {
    BlindFlight flight{AircraftClass::light, {{30, 0, 0}, {25, 0, 60}, {55, 6, 60}, {300, 0, 60}}};
    flight.change = [](AircraftState& a, base::Time now) {
        const double t = static_cast<double>(now.ns - kStart) / 1e9;
        if (t > 70 && t < 75) a[Signal::standard_altitude] = {};
    };
    EXPECT_FALSE(has(flight.phases(), "cruise"));
}

TEST(MotionPhaseDetector, who_hovers_or_flies_against_the_wind_is_not_on_the_ground) {
    const std::vector<Leg> slow = {{0.1, 0, 50}, {120, 0, 50}, {300, 0, 0.8}, {200, 0, 50}};
    for (const AircraftClass aircraft : {AircraftClass::helicopter, AircraftClass::light, AircraftClass::glider}) {
        const auto phases = BlindFlight{aircraft, slow, 2000}.phases();
        EXPECT_TRUE(has(phases, "cruise")) << static_cast<int>(aircraft);
        EXPECT_FALSE(has(phases, "ground")) << static_cast<int>(aircraft);
    }
    BlindFlight after_descent{AircraftClass::light, {{0.1, 0, 50}, {60, -4, 50}, {60, 0, 10}, {40, 0, 5}}, 2000};
    EXPECT_TRUE(has(after_descent.phases(), "ground")) << "control: a landing looks like that";
    after_descent.change = [](AircraftState& a, base::Time now) { put(a, Signal::indicated_airspeed, 40, now); };
    EXPECT_FALSE(has(after_descent.phases(), "ground")) << "its airspeed carries it";
}

TEST(MotionPhaseDetector, a_glider_that_climbs_out_of_its_final_is_in_cruise_again) {
    const std::vector<Leg> saved = {{0.1, 0, 25}, {100, 0, 25}, {295, -2, 25}, {400, 3, 25}, {300, 0, 25}};
    const auto phases = BlindFlight{AircraftClass::glider, saved, 640, [](double) { return true; }}.phases();
    EXPECT_TRUE(has(phases, "approach.final"));
    EXPECT_EQ(phases.back(), "cruise");
}

TEST(MotionPhaseDetector, without_a_height_a_level_segment_of_an_approach_is_no_cruise) {
    for (const AircraftClass aircraft : {AircraftClass::light, AircraftClass::jet, AircraftClass::helicopter}) {
        const double level_s = motion_phase_settings(aircraft).level_unseen.to_seconds() - 10;
        const std::vector<Leg> approach = {{0.1, 0, 70}, {60, 0, 70}, {200, -4, 70}, {level_s, 0, 70}, {100, -4, 60}};
        const auto phases = BlindFlight{aircraft, approach, 2500}.phases();
        EXPECT_EQ(phases.back(), "approach.descent") << static_cast<int>(aircraft);
        EXPECT_EQ(std::count(phases.begin(), phases.end(), "cruise"), 1) << static_cast<int>(aircraft);
    }
}

TEST(MotionPhaseDetector, a_descent_at_any_rate_is_no_cruise_on_the_way_down) {
    for (const double rate : {-1.1, -1.25, -1.4, -1.6, -1.75, -2.0, -3.0}) {
        const auto phases = BlindFlight{
            AircraftClass::light, {{0.1, 0, 60}, {60, 0, 60}, {1000 / -rate, rate, 60}}, 1200, [](double) {
                return true;
            }}.phases();
        EXPECT_LE(std::count(phases.begin(), phases.end(), "cruise"), 1) << rate;
        EXPECT_NE(phases.back(), "cruise") << rate;
    }
}

/// A climb that began before the height was known has not risen 30 m.
TEST(MotionPhaseDetector, a_height_that_returns_begins_every_condition_anew) {
    BlindFlight flight{
        AircraftClass::light, {{0.1, 0, 50}, {150, -3, 50}, {16, 3, 50}}, 640, [](double t) { return t < 151 || t > 162.5; }};
    EXPECT_TRUE(has(flight.phases(), "approach.final"));
    EXPECT_FALSE(has(flight.phases(), "go_around.abort"));
}

/// Level at 700 m above ground: a light aircraft cruises there, a jet does not.
TEST(MotionPhaseDetector, the_height_of_cruise_is_that_of_the_class) {
    const auto found = [](AircraftClass aircraft) {
        MotionPhaseState state;
        base::Time now{kStart};
        PhaseStatement stated;
        for (int n = 0; n < 400; ++n) {
            now = now + base::Duration::milliseconds(100);
            stated = detect_motion_phase(aircraft_at({60, 0, 700, 0}, now, HeightFrom::terrain), now,
                                         motion_phase_settings(aircraft), state);
        }
        return name_of(stated);
    };
    for (const AircraftClass aircraft : {AircraftClass::light, AircraftClass::helicopter, AircraftClass::glider})
        EXPECT_EQ(found(aircraft), "cruise");
    for (const AircraftClass aircraft : {AircraftClass::jet, AircraftClass::unstated}) EXPECT_EQ(found(aircraft), "-");
}

TEST(MotionPhaseDetector, stale_bad_and_nan_inputs_count_as_missing) {
    base::Time now;
    const MotionPhaseState state = cruising(now);
    const auto stated_with = [&](const std::function<void(AircraftState&, base::Time)>& change) {
        MotionPhaseState s = state;
        base::Time t = now;
        return go_on(s, t, 0.1, [&](AircraftState& a) { change(a, t); }).stated;
    };
    EXPECT_TRUE(stated_with([](AircraftState&, base::Time) {}));
    EXPECT_FALSE(stated_with([](AircraftState& a, base::Time t) {
        a[Signal::ground_speed] = {150, t - base::Duration::seconds(5)};
    }));
    EXPECT_FALSE(stated_with([](AircraftState& a, base::Time t) { a[Signal::ground_speed] = {150, t, base::Quality::bad}; }));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::ground_speed] = {bad, t}; }));
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::vertical_speed] = {bad, t}; }));
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::height_above_terrain] = {bad, t}; }));
    }
}

TEST(MotionPhaseDetector, the_own_ship_estimate_replaces_missing_speeds) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const auto estimate = [](AircraftState& a) {
        a[Signal::ground_speed] = {};
        a[Signal::vertical_speed] = {};
        a.own_ship.velocity_north_mps = 90;
        a.own_ship.velocity_east_mps = 120;
        a.own_ship.state = base::SignalState::valid;
    };
    EXPECT_TRUE(go_on(state, now, 1, estimate).stated);
    EXPECT_FALSE(go_on(state, now, 1, [&](AircraftState& a) {
                     estimate(a);
                     a.own_ship.state = base::SignalState::stale;
                 }).stated);
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
        const base::Time now{kStart + i * 100'000'000LL};
        const Sample s{80, 0, 450, 0};
        const PhaseStatement found = detect_motion_phase(aircraft_at(s, now, HeightFrom::terrain), now, reckless, state);
        ASSERT_FALSE(found.stated && prioritized_aspect(found.phase) != Aspect::terrain);
    }
    const base::Time later{kStart + 3000 * 100'000'000LL};
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
        const base::Time now{kStart + i * 5'000'000'000LL};
        found = detect_motion_phase(aircraft_at({150, 0, 3000, 0}, now, HeightFrom::terrain), now, {}, state);
    }
    EXPECT_FALSE(found.stated) << "5 s between updates: nobody knows what happened between them";
}

TEST(MotionPhaseDetector, asking_twice_at_one_instant_changes_nothing) {
    MotionPhaseState once, twice;
    for (int i = 0; i < 1000; ++i) {
        const base::Time now{kStart + i * 100'000'000LL};
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
