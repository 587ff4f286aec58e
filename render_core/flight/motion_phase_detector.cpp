#include "render_core/flight/motion_phase_detector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tedavis::flight {
namespace {

using Settings = MotionPhaseSettings;
using Stage = MotionStage;

/// What the rules look at. Vertical speed is smoothed.
struct Motion {
    double ground_speed = 0;
    double vertical_speed = 0;
    bool has_height = false;
    double height = 0;         // radio height where it is believed, else from the terrain database
    double lowest_height = 0;  // the lower of both; infinite where neither is known
    double near_ground = 0;    // by how much heights near the ground may be too large
    bool remembers_ground = false;
    bool has_climbed = false;
    double climbed = 0;       // above the ground that is remembered, where no height is known
    bool flies = false;       // by its airspeed
    double acceleration = 0;  // 0 when it is not known
    bool was_level = false;   // the level condition held at the last update
};

bool read_valid(const AircraftState& aircraft, Signal signal, base::Time now, double& value) {
    value = aircraft[signal].value_or(0);
    return aircraft.is_valid(signal, now) && std::isfinite(value);
}

bool read_speeds(const AircraftState& aircraft, base::Time now, const Settings& settings, Motion& motion) {
    const OwnShipEstimate& own = aircraft.own_ship;
    const double horizontal = std::hypot(own.velocity_north_mps, own.velocity_east_mps);
    const bool estimated =
        own.state == base::SignalState::valid && std::isfinite(horizontal) && std::isfinite(own.velocity_up_mps);
    const bool fast = read_valid(aircraft, Signal::ground_speed, now, motion.ground_speed);
    const bool vertical = read_valid(aircraft, Signal::vertical_speed, now, motion.vertical_speed);
    if (!fast) motion.ground_speed = horizontal;
    if (!vertical) motion.vertical_speed = own.velocity_up_mps;
    if (!read_valid(aircraft, Signal::longitudinal_acceleration, now, motion.acceleration)) motion.acceleration = 0;
    double airspeed = 0;
    motion.flies = read_valid(aircraft, Signal::indicated_airspeed, now, airspeed) && airspeed > settings.takeoff_speed_mps;
    return (fast || estimated) && (vertical || estimated);
}

void read_height(const AircraftState& aircraft, base::Time now, const Settings& settings, Motion& motion) {
    double radio = 0, terrain = 0;
    const bool has_radio = read_valid(aircraft, Signal::radio_height, now, radio) && radio < settings.radio_height_limit_m;
    const bool has_terrain = read_valid(aircraft, Signal::height_above_terrain, now, terrain);
    motion.height = has_radio ? radio : terrain;
    motion.has_height = has_radio || has_terrain;
    motion.lowest_height = has_radio && has_terrain ? std::min(radio, terrain) : motion.height;
    if (!motion.has_height) motion.lowest_height = std::numeric_limits<double>::infinity();
    motion.near_ground = has_radio ? 0 : settings.terrain_height_margin_m;
}

GroundAltitude read_altitude(const AircraftState& aircraft, base::Time now, double& altitude) {
    if (read_valid(aircraft, Signal::standard_altitude, now, altitude)) return GroundAltitude::standard;
    altitude = aircraft.own_ship.position.height.m;
    const bool is_known = aircraft.own_ship.state == base::SignalState::valid && std::isfinite(altitude);
    return is_known ? GroundAltitude::own_ship : GroundAltitude::none;
}

/// The ground below is remembered while its height is known, and while the aircraft stands. An aircraft far below that altitude,
/// or high above it, has left the place, and so has one after some minutes.
void follow_ground(const AircraftState& aircraft, base::Time now, const Settings& settings, MotionPhaseState& state,
                   Motion& motion) {
    constexpr double kFarBelow_m = 30;
    double altitude = 0;
    const GroundAltitude source = read_altitude(aircraft, now, altitude);
    const bool is_on_ground = state.stage == Stage::ground && motion.ground_speed < settings.standing_speed_mps;
    if (source != GroundAltitude::none && (motion.has_height || is_on_ground)) {
        state.ground = source;
        state.ground_m = motion.has_height ? altitude - motion.lowest_height : altitude;
        state.ground_at = now;
    }
    motion.climbed = altitude - state.ground_m;
    motion.has_climbed = state.ground != GroundAltitude::none && source == state.ground;
    const bool has_left = motion.has_climbed && (motion.climbed < -kFarBelow_m || motion.climbed > settings.cruise_height_m);
    if (!motion.has_height && (has_left || now - state.ground_at > settings.forget_ground_after))
        state.ground = GroundAltitude::none;
    motion.remembers_ground = state.ground != GroundAltitude::none;
    motion.has_climbed = motion.has_climbed && motion.remembers_ground;
}

bool stands(const Motion& m, const Settings& s) {
    return m.has_height && m.ground_speed < s.standing_speed_mps && m.height < s.ground_height_m + m.near_ground;
}
/// Without a height: slow, level, and without an airspeed that would carry it.
bool rests(const Motion& m, const Settings& s) {
    return !m.has_height && !m.flies && m.ground_speed < s.standing_speed_mps &&
           std::abs(m.vertical_speed) < s.standing_climb_mps;
}
/// A glider may hang in the wind; none hangs as still as that.
bool lies_still(const Motion& m, const Settings& s) {
    constexpr double kStill_mps = 0.5, kStillClimb_mps = 0.2;
    return s.soars && rests(m, s) && m.ground_speed < kStill_mps && std::abs(m.vertical_speed) < kStillClimb_mps;
}
bool runs(const Motion& m, const Settings& s) {
    return m.ground_speed > s.takeoff_speed_mps ||
           (m.ground_speed > s.takeoff_run_speed_mps && m.acceleration > s.takeoff_acceleration_mps2);
}
bool accelerates(const Motion& m, const Settings& s) {
    return m.ground_speed > s.takeoff_run_speed_mps && m.acceleration > s.takeoff_acceleration_mps2;
}
bool lifts_off(const Motion& m, const Settings& s) {
    const bool is_above = m.has_height || m.has_climbed;
    const double height = m.has_height ? m.height : m.climbed;
    return is_above && height > s.lift_off_height_m + m.near_ground && m.vertical_speed > s.not_climbing_mps;
}
bool climbs_low(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed > s.climb_mps && m.height > s.lift_off_height_m + m.near_ground &&
           m.height < s.second_climb_height_m;
}
bool climbs_high(const Motion& m, const Settings& s) {
    const bool is_above = m.has_height ? m.height > s.second_climb_height_m
                                       : !m.remembers_ground || (m.has_climbed && m.climbed > s.second_climb_height_m);
    return m.vertical_speed > s.climb_mps && is_above;
}
bool climbs_again(const Motion& m, const Settings& s) {
    return m.vertical_speed > s.go_around_climb_mps && (!m.has_height || m.height > s.second_climb_height_m);
}
bool goes_around(const Motion& m, const Settings& s) { return m.vertical_speed > s.go_around_climb_mps; }
/// A glider counts as steady whenever it moves, climbing or sinking.
bool is_steady(const Motion& m, const Settings& s) {
    const double limit = s.level_mps + (m.was_level ? s.level_hysteresis_mps : 0);
    return s.soars ? m.ground_speed > s.standing_speed_mps : std::abs(m.vertical_speed) < limit;
}
bool is_level(const Motion& m, const Settings& s) { return m.has_height && is_steady(m, s) && m.height > s.cruise_height_m; }
/// Without a height, and not within the height of cruise above the ground that is remembered.
bool is_level_unseen(const Motion& m, const Settings& s) { return !m.has_height && is_steady(m, s) && !m.remembers_ground; }
bool leaves_approach(const Motion& m, const Settings& s) { return m.has_height && m.height > s.initial_height_m; }
bool levels_low(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed < s.level_mps && m.vertical_speed >= -s.approach_descent_mps &&
           m.height <= s.cruise_height_m;
}
bool descends(const Motion& m, const Settings& s) {
    return m.vertical_speed < -s.descent_mps && (!m.has_height || m.height >= s.initial_height_m);
}
bool descends_low(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed < -s.approach_descent_mps && m.height < s.initial_height_m;
}
bool is_initial(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed < 0 && m.height < s.initial_height_m;
}
bool is_final(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed < s.not_climbing_mps && m.height < s.final_height_m;
}
bool touches_down(const Motion& m, const Settings& s) {
    return m.has_height && m.vertical_speed < s.not_climbing_mps && m.height < s.ground_height_m + m.near_ground;
}
bool is_high_enough(const Motion& m, const Settings& s) { return m.has_height && m.height > s.replanning_height_m; }
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
    {from(Stage::none, Stage::takeoff_start, Stage::descent, Stage::initial, Stage::final, Stage::landing), Stage::ground, rests,
     &Settings::resting},
    {~from(Stage::ground), Stage::ground, lies_still, &Settings::lying},
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
    {from(Stage::none, Stage::low_flight, Stage::takeoff_start, Stage::first_climb, Stage::second_climb), Stage::cruise, is_level,
     &Settings::level},
    {from(Stage::none, Stage::low_flight, Stage::takeoff_start, Stage::first_climb, Stage::second_climb), Stage::cruise,
     is_level_unseen, &Settings::level},
    {from(Stage::descent, Stage::initial, Stage::final, Stage::landing), Stage::cruise, is_level, &Settings::level_after_descent},
    {from(Stage::descent), Stage::cruise, is_level_unseen, &Settings::level_unseen},
    {from(Stage::final, Stage::landing), Stage::low_flight, leaves_approach, &Settings::vertical},
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
        motion.was_level = (rule.holds == is_level || rule.holds == is_level_unseen) && state.timers[i].running;
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
    if (!state.any_update) {
        state.last_complete = state.last_speeds = now;
        state.last_height = now - settings.forget_after + settings.brief;  // one that was never there is not waited for
    }
    if (state.any_update && now - state.last_update > settings.longest_step) {
        stop_timers(state);
        state.smoothed = false;
    }
    if (now - state.last_speeds > settings.forget_after) forget(state);
    return true;
}

PhaseStatement statement_of(const MotionPhaseState& state) {
    const bool complete = state.any_update && state.last_complete == state.last_update;
    return {phase_of(state.stage), complete && state.stage != Stage::none};
}

void rest(base::Time now, MotionPhaseState& state) {
    stop_timers(state);
    state.smoothed = false;
    if (state.last_complete == now) state.last_complete = now - base::Duration{1};
}

/// True where the rules can be followed; without a height they can only once it is clear that there is none.
bool read_motion(const AircraftState& aircraft, base::Time now, const Settings& settings, MotionPhaseState& state,
                 Motion& motion) {
    const bool has_speeds = read_speeds(aircraft, now, settings, motion);
    read_height(aircraft, now, settings, motion);
    if (has_speeds) state.last_speeds = now;
    if (motion.has_height) state.last_height = now;
    if (motion.has_height != state.had_height) stop_timers(state);  // of conditions on another height, or on none
    state.had_height = motion.has_height;
    if (!has_speeds || (!motion.has_height && now - state.last_height <= settings.forget_after)) return false;
    follow_ground(aircraft, now, settings, state, motion);
    return true;
}

}  // namespace

PhaseStatement detect_motion_phase(const AircraftState& aircraft, base::Time now, const MotionPhaseSettings& settings,
                                   MotionPhaseState& state) {
    if (!settings.is_enabled) return {};
    if (!advance(now, settings, state)) return statement_of(state);
    const base::Duration step = state.any_update ? now - state.last_update : base::Duration{};
    state.any_update = true;
    state.last_update = now;
    Motion motion;
    if (!read_motion(aircraft, now, settings, state, motion)) {
        rest(now, state);
        return statement_of(state);
    }
    state.last_complete = now;
    smooth(motion, step, settings, state);
    follow_rules(motion, now, settings, state);
    return statement_of(state);
}

}  // namespace tedavis::flight
