#include "render_core/flight/motion_phase_detector.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::flight {
namespace {

using Settings = MotionPhaseSettings;
using Stage = MotionStage;

/// What the rules look at. Vertical speed is smoothed.
struct Motion {
    double ground_speed = 0;
    double vertical_speed = 0;
    double height = 0;         // radio height where it is believed, else from the terrain database
    double lowest_height = 0;  // the lower of both
    double near_ground = 0;    // by how much heights near the ground may be too large
    double acceleration = 0;   // 0 when it is not known
    bool was_level = false;    // the level condition held at the last update
};

bool read_valid(const AircraftState& aircraft, Signal signal, base::Time now, double& value) {
    value = aircraft[signal].value_or(0);
    return aircraft.is_valid(signal, now) && std::isfinite(value);
}

bool read_speeds(const AircraftState& aircraft, base::Time now, Motion& motion) {
    const OwnShipEstimate& own = aircraft.own_ship;
    const double horizontal = std::hypot(own.velocity_north_mps, own.velocity_east_mps);
    const bool estimated =
        own.state == base::SignalState::valid && std::isfinite(horizontal) && std::isfinite(own.velocity_up_mps);
    const bool fast = read_valid(aircraft, Signal::ground_speed, now, motion.ground_speed);
    const bool vertical = read_valid(aircraft, Signal::vertical_speed, now, motion.vertical_speed);
    if (!fast) motion.ground_speed = horizontal;
    if (!vertical) motion.vertical_speed = own.velocity_up_mps;
    if (!read_valid(aircraft, Signal::longitudinal_acceleration, now, motion.acceleration)) motion.acceleration = 0;
    return (fast || estimated) && (vertical || estimated);
}

bool read_height(const AircraftState& aircraft, base::Time now, const Settings& settings, Motion& motion) {
    double radio = 0, terrain = 0;
    const bool has_radio = read_valid(aircraft, Signal::radio_height, now, radio) && radio < settings.radio_height_limit_m;
    const bool has_terrain = read_valid(aircraft, Signal::height_above_terrain, now, terrain);
    motion.height = has_radio ? radio : terrain;
    motion.lowest_height = has_radio && has_terrain ? std::min(radio, terrain) : motion.height;
    motion.near_ground = has_radio ? 0 : settings.terrain_height_margin_m;
    return has_radio || has_terrain;
}

bool stands(const Motion& m, const Settings& s) {
    return m.ground_speed < s.standing_speed_mps && m.height < s.ground_height_m + m.near_ground;
}
bool runs(const Motion& m, const Settings& s) {
    return m.ground_speed > s.takeoff_speed_mps ||
           (m.ground_speed > s.takeoff_run_speed_mps && m.acceleration > s.takeoff_acceleration_mps2);
}
bool accelerates(const Motion& m, const Settings& s) {
    return m.ground_speed > s.takeoff_run_speed_mps && m.acceleration > s.takeoff_acceleration_mps2;
}
bool lifts_off(const Motion& m, const Settings& s) {
    return m.height > s.lift_off_height_m + m.near_ground && m.vertical_speed > s.not_climbing_mps;
}
bool climbs_low(const Motion& m, const Settings& s) {
    return m.vertical_speed > s.climb_mps && m.height > s.lift_off_height_m + m.near_ground && m.height < s.second_climb_height_m;
}
bool climbs_high(const Motion& m, const Settings& s) {
    return m.vertical_speed > s.climb_mps && m.height > s.second_climb_height_m;
}
bool climbs_again(const Motion& m, const Settings& s) {
    return m.vertical_speed > s.go_around_climb_mps && m.height > s.second_climb_height_m;
}
bool goes_around(const Motion& m, const Settings& s) { return m.vertical_speed > s.go_around_climb_mps; }
bool is_level(const Motion& m, const Settings& s) {
    const double limit = s.level_mps + (m.was_level ? s.level_hysteresis_mps : 0);
    return std::abs(m.vertical_speed) < limit && m.height > s.cruise_height_m;
}
bool levels_low(const Motion& m, const Settings& s) {
    return m.vertical_speed < s.level_mps && m.vertical_speed >= -s.approach_descent_mps && m.height <= s.cruise_height_m;
}
bool descends(const Motion& m, const Settings& s) { return m.vertical_speed < -s.descent_mps && m.height >= s.initial_height_m; }
bool descends_low(const Motion& m, const Settings& s) {
    return m.vertical_speed < -s.approach_descent_mps && m.height < s.initial_height_m;
}
bool is_initial(const Motion& m, const Settings& s) { return m.vertical_speed < 0 && m.height < s.initial_height_m; }
bool is_final(const Motion& m, const Settings& s) { return m.vertical_speed < s.not_climbing_mps && m.height < s.final_height_m; }
bool touches_down(const Motion& m, const Settings& s) {
    return m.vertical_speed < s.not_climbing_mps && m.height < s.ground_height_m + m.near_ground;
}
bool is_high_enough(const Motion& m, const Settings& s) { return m.height > s.replanning_height_m; }
bool is_low(const Motion& m, const Settings& s) { return m.lowest_height < s.terrain_priority_height_m; }

constexpr std::uint32_t bit(Stage stage) { return std::uint32_t{1} << static_cast<unsigned>(stage); }
template <class... Stages>
constexpr std::uint32_t from(Stages... stages) {
    return (bit(stages) | ...);
}

struct Rule {
    std::uint32_t from;
    Stage to;
    bool (*holds)(const Motion&, const Settings&);
    base::Duration Settings::*dwell;
    double Settings::*rise = nullptr;  // height to be gained while it holds
};

/// The first rule that is due wins.
constexpr Rule kRules[] = {
    {from(Stage::cruise, Stage::replanning), Stage::low_flight, is_low, &Settings::brief},
    {~from(Stage::ground), Stage::ground, stands, &Settings::standing},
    {from(Stage::ground), Stage::takeoff_start, runs, &Settings::brief},
    {from(Stage::landing), Stage::takeoff_start, accelerates, &Settings::brief},
    {from(Stage::ground, Stage::takeoff_start), Stage::first_climb, lifts_off, &Settings::brief},
    {from(Stage::first_climb), Stage::second_climb, climbs_high, &Settings::usual},
    {from(Stage::initial, Stage::final, Stage::landing), Stage::abort, goes_around, &Settings::go_around,
     &Settings::go_around_rise_m},
    {from(Stage::abort), Stage::replanning, is_high_enough, &Settings::usual},
    {from(Stage::final), Stage::landing, touches_down, &Settings::brief},
    {from(Stage::initial), Stage::final, is_final, &Settings::usual},
    {from(Stage::descent), Stage::initial, is_initial, &Settings::usual},
    {from(Stage::none, Stage::low_flight, Stage::first_climb, Stage::second_climb, Stage::cruise, Stage::abort,
          Stage::replanning),
     Stage::initial, descends_low, &Settings::vertical},
    {from(Stage::none, Stage::low_flight, Stage::first_climb, Stage::second_climb, Stage::cruise, Stage::replanning),
     Stage::descent, descends, &Settings::vertical},
    {from(Stage::none, Stage::low_flight, Stage::first_climb, Stage::second_climb, Stage::descent, Stage::initial), Stage::cruise,
     is_level, &Settings::level},
    {from(Stage::replanning), Stage::cruise, is_level, &Settings::level_after_replanning},
    {from(Stage::second_climb, Stage::abort), Stage::low_flight, levels_low, &Settings::vertical},
    {from(Stage::none, Stage::descent, Stage::low_flight), Stage::second_climb, climbs_again, &Settings::vertical},
    {from(Stage::none), Stage::first_climb, climbs_low, &Settings::vertical},
};
constexpr std::size_t kRuleCount = sizeof kRules / sizeof kRules[0];
static_assert(kRuleCount <= kMaxMotionRules);

FlightPhase phase_of(Stage stage) {
    switch (stage) {
        case Stage::none: return {};
        case Stage::ground: return {Scenario::ground, 0};
        case Stage::takeoff_start: return kTakeoffStart;
        case Stage::first_climb: return kTakeoffFirstClimb;
        case Stage::second_climb: return kTakeoffSecondClimb;
        case Stage::cruise: return {Scenario::cruise, 0};
        case Stage::descent: return kApproachDescent;
        case Stage::initial: return kApproachInitial;
        case Stage::final: return kApproachFinal;
        case Stage::landing: return kApproachLanding;
        case Stage::abort: return kGoAroundAbort;
        case Stage::replanning: return kGoAroundReplanning;
        case Stage::low_flight: return {};
    }
    return {};
}

void stop_timers(MotionPhaseState& state) { state.timers = {}; }

void forget(MotionPhaseState& state) {
    stop_timers(state);
    state.stage = Stage::none;
}

bool takes_priority_from_terrain(Stage to) { return prioritized_aspect(phase_of(to)) != Aspect::terrain; }

bool is_due(const Rule& rule, MotionPhaseState::Timer& timer, const Motion& motion, base::Time now, const Settings& settings) {
    if (!rule.holds(motion, settings)) {
        timer = {};
        return false;
    }
    if (!timer.running) timer = {now, motion.height, true};
    const bool risen = rule.rise == nullptr || motion.height - timer.height_m >= settings.*rule.rise;
    return risen && now - timer.since >= settings.*rule.dwell;
}

void follow_rules(Motion motion, base::Time now, const Settings& settings, MotionPhaseState& state) {
    for (std::size_t i = 0; i < kRuleCount; ++i) {
        const Rule& rule = kRules[i];
        if ((rule.from & bit(state.stage)) == 0) continue;
        motion.was_level = rule.holds == is_level && state.timers[i].running;
        if (!is_due(rule, state.timers[i], motion, now, settings)) continue;
        if (takes_priority_from_terrain(rule.to) && motion.lowest_height < settings.terrain_priority_height_m) continue;
        stop_timers(state);
        state.stage = rule.to;
        return;
    }
}

void smooth(Motion& motion, base::Duration step, const Settings& settings, MotionPhaseState& state) {
    const double share = state.smoothed ? -std::expm1(-step.to_seconds() / settings.smoothing.to_seconds()) : 1.0;
    state.vertical_speed_mps += share * (motion.vertical_speed - state.vertical_speed_mps);
    state.smoothed = true;
    motion.vertical_speed = state.vertical_speed_mps;
}

/// Handles the passage of time; false when `now` has been dealt with already.
bool advance(base::Time now, const Settings& settings, MotionPhaseState& state) {
    if (state.any_update && now == state.last_update) return false;
    if (state.any_update && now < state.last_update) state = {};
    if (!state.any_update) state.last_complete = now;
    if (state.any_update && now - state.last_update > settings.longest_step) {
        stop_timers(state);
        state.smoothed = false;
    }
    if (now - state.last_complete > settings.forget_after) forget(state);
    return true;
}

PhaseStatement statement_of(const MotionPhaseState& state) {
    const bool complete = state.any_update && state.last_complete == state.last_update;
    return {phase_of(state.stage), complete && state.stage != Stage::none};
}

}  // namespace

PhaseStatement detect_motion_phase(const AircraftState& aircraft, base::Time now, const MotionPhaseSettings& settings,
                                   MotionPhaseState& state) {
    if (!advance(now, settings, state)) return statement_of(state);
    const base::Duration step = state.any_update ? now - state.last_update : base::Duration{};
    state.any_update = true;
    state.last_update = now;
    Motion motion;
    const bool has_speeds = read_speeds(aircraft, now, motion);
    const bool has_height = read_height(aircraft, now, settings, motion);
    if (!has_speeds || !has_height) {
        stop_timers(state);
        state.smoothed = false;
        if (state.last_complete == now) state.last_complete = now - base::Duration{1};
        return statement_of(state);
    }
    state.last_complete = now;
    smooth(motion, step, settings, state);
    follow_rules(motion, now, settings, state);
    return statement_of(state);
}

}  // namespace tedavis::flight
