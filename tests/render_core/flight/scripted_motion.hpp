// Flights by legs, as the detector of phases is told them: exact motion at any time, and what it states along the way.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "render_core/flight/motion_phase_detector.hpp"
#include "render_core/flight/phase_statement.hpp"

namespace tedavis::flight::scripted_motion {

inline constexpr std::int64_t kMotionStart = 1'700'000'000'000'000'000;

inline std::string name_of(PhaseStatement statement) {
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
inline Sample sample_at(const std::vector<Leg>& legs, double t) {
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

inline double length_of(const std::vector<Leg>& legs) {
    double seconds = 0;
    for (const Leg& leg : legs) seconds += leg.seconds;
    return seconds;
}

inline void put(AircraftState& aircraft, Signal signal, double value, base::Time at) { aircraft[signal] = {value, at}; }

enum class HeightFrom { radio, terrain };

inline AircraftState aircraft_at(const Sample& s, base::Time now, HeightFrom height_from) {
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
inline std::vector<std::string> fly(const Script& script, MotionPhaseState& state) {
    std::vector<std::string> phases;
    std::mt19937_64 random(77);
    std::uniform_real_distribution<double> noise(-script.vertical_noise, script.vertical_noise);
    const MotionPhaseSettings settings;
    for (double t = 0; t < length_of(script.legs); t += script.step(t)) {
        const base::Time now{kMotionStart + std::llround(t * 1e9)};
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

inline std::vector<std::string> fly(const Script& script) {
    MotionPhaseState state;
    return fly(script, state);
}

inline const std::vector<Leg> kToCruise = {{20, 0, 0}, {25, 0, 60}, {60, 6, 80}, {200, 9, 120}, {120, 0, 150}};
inline const std::vector<Leg> kDownToFinal = {{260, -5, 90}, {80, -4, 70}, {90, -4, 60}};

inline std::vector<Leg> joined(std::initializer_list<std::vector<Leg>> parts) {
    std::vector<Leg> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

inline PhaseStatement go_on(MotionPhaseState& state, base::Time& now, double seconds,
                            const std::function<void(AircraftState&)>& change, Sample s = {150, 0, 2160, 0}) {
    PhaseStatement found;
    for (double t = 0; t < seconds; t += 0.1) {
        now = now + base::Duration::milliseconds(100);
        AircraftState aircraft = aircraft_at(s, now, HeightFrom::terrain);
        change(aircraft);
        found = detect_motion_phase(aircraft, now, {}, state);
    }
    return found;
}
inline const auto kNoChange = [](AircraftState&) {};

/// Ground to cruise (2160 m), down to 180 m, land, stop.
inline const std::vector<Leg> kWholeFlight =
    joined({kToCruise, kDownToFinal, {{60, -3, 50}, {5, -0.5, 45}, {40, 0, 5}, {30, 0, 5}}});
inline const std::vector<std::string> kWholeFlightPhases = {
    "ground",           "takeoff.start",    "takeoff.first_climb", "takeoff.second_climb", "cruise",
    "approach.descent", "approach.initial", "approach.final",      "approach.landing",     "ground"};

/// In cruise at 2160 m; the state from there on.
inline MotionPhaseState cruising(base::Time& now) {
    MotionPhaseState state;
    static_cast<void>(fly({kToCruise}, state));
    EXPECT_EQ(state.stage, MotionStage::cruise);
    now = state.last_update;
    return state;
}

}  // namespace tedavis::flight::scripted_motion
