// Flights over ground whose height nobody knows, or knows at times only; and what each class of aircraft is told by there.
#include "render_core/flight/motion_phase_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/render_core/flight/scripted_motion.hpp"

namespace tedavis::flight::test_motion_phase_unseen_ground {
namespace {

using namespace scripted_motion;

/// Height above the place of the departure is that of the pressure altitude.
TEST(MotionPhaseUnseenGround, without_a_height_a_flight_is_told_by_speed_climb_and_altitude) {
    MotionPhaseState state;
    std::vector<std::string> phases;
    for (double t = 0; t < length_of(kWholeFlight); t += 0.1) {
        const base::Time now{kMotionStart + std::llround(t * 1e9)};
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

/// Launch, thermals of two minutes with glides between them, a landing: climbs at 3 m/s, sinks at 1.5 m/s.
TEST(MotionPhaseUnseenGround, a_glider_that_circles_in_thermals_is_in_cruise) {
    std::vector<Leg> legs = {{30, 0, 0}, {10, 0, 22}, {100, 7, 28}};
    for (int n = 0; n < 6; ++n) legs.insert(legs.end(), {{120, 3, 25}, {200, -1.5, 32}});
    legs.insert(legs.end(), {{800, -1.5, 30}, {60, 0, 1}, {140, 0, 0}});
    const auto phases = [&](AircraftClass aircraft, bool has_height) {
        MotionPhaseState state;
        std::vector<std::string> found;
        for (double t = 0; t < length_of(legs); t += 0.1) {
            const base::Time now{kMotionStart + std::llround(t * 1e9)};
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
            const base::Time now{kMotionStart + std::llround(t * 1e9)};
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

TEST(MotionPhaseUnseenGround, who_leaves_the_database_low_is_not_in_cruise_before_the_ground_is_forgotten) {
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

TEST(MotionPhaseUnseenGround, level_flight_low_above_the_departure_is_no_cruise) {
    const std::vector<Leg> circuit = {{30, 0, 0}, {25, 0, 60}, {55, 6, 60}, {300, 0, 60}};
    for (const AircraftClass aircraft : {AircraftClass::light, AircraftClass::jet, AircraftClass::unstated})
        EXPECT_FALSE(has(BlindFlight{aircraft, circuit}.phases(), "cruise")) << static_cast<int>(aircraft);
}

/// The departure is still known after the altitude was missing for some seconds.
TEST(MotionPhaseUnseenGround, a_gap_of_the_altitude_does_not_lose_the_departure) {
    BlindFlight flight{AircraftClass::light, {{30, 0, 0}, {25, 0, 60}, {55, 6, 60}, {300, 0, 60}}};
    flight.change = [](AircraftState& a, base::Time now) {
        const double t = static_cast<double>(now.ns - kMotionStart) / 1e9;
        if (t > 70 && t < 75) a[Signal::standard_altitude] = {};
    };
    EXPECT_FALSE(has(flight.phases(), "cruise"));
}

TEST(MotionPhaseUnseenGround, who_hovers_or_flies_against_the_wind_is_not_on_the_ground) {
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

TEST(MotionPhaseUnseenGround, a_glider_that_climbs_out_of_its_final_is_in_cruise_again) {
    const std::vector<Leg> saved = {{0.1, 0, 25}, {100, 0, 25}, {295, -2, 25}, {400, 3, 25}, {300, 0, 25}};
    const auto phases = BlindFlight{AircraftClass::glider, saved, 640, [](double) { return true; }}.phases();
    EXPECT_TRUE(has(phases, "approach.final"));
    EXPECT_EQ(phases.back(), "cruise");
}

TEST(MotionPhaseUnseenGround, without_a_height_a_level_segment_of_an_approach_is_no_cruise) {
    for (const AircraftClass aircraft : {AircraftClass::light, AircraftClass::jet, AircraftClass::helicopter}) {
        const double level_s = motion_phase_settings(aircraft).level_unseen.to_seconds() - 10;
        const std::vector<Leg> approach = {{0.1, 0, 70}, {60, 0, 70}, {200, -4, 70}, {level_s, 0, 70}, {100, -4, 60}};
        const auto phases = BlindFlight{aircraft, approach, 2500}.phases();
        EXPECT_EQ(phases.back(), "approach.descent") << static_cast<int>(aircraft);
        EXPECT_EQ(std::count(phases.begin(), phases.end(), "cruise"), 1) << static_cast<int>(aircraft);
    }
}

TEST(MotionPhaseUnseenGround, a_descent_at_any_rate_is_no_cruise_on_the_way_down) {
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
TEST(MotionPhaseUnseenGround, a_height_that_returns_begins_every_condition_anew) {
    BlindFlight flight{
        AircraftClass::light, {{0.1, 0, 50}, {150, -3, 50}, {16, 3, 50}}, 640, [](double t) { return t < 151 || t > 162.5; }};
    EXPECT_TRUE(has(flight.phases(), "approach.final"));
    EXPECT_FALSE(has(flight.phases(), "go_around.abort"));
}

/// Level at 700 m above ground: a light aircraft cruises there, a jet does not.
TEST(MotionPhaseUnseenGround, the_height_of_cruise_is_that_of_the_class) {
    const auto found = [](AircraftClass aircraft) {
        MotionPhaseState state;
        base::Time now{kMotionStart};
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

}  // namespace
}  // namespace tedavis::flight::test_motion_phase_unseen_ground
