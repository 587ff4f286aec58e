/// Detects the flight phase from the aircraft's motion, for when neither switches nor bus state one.
///
/// An online state machine on ground speed, vertical speed and height above ground; each transition requires its condition to
/// hold without interruption for a certain time, and there is hysteresis between entering and leaving a phase. Phases follow
/// thesis section 3.1; the thresholds are settings, by the class of the aircraft (motion_phase_settings.hpp).
///
/// - Without a valid speed or vertical speed there is no statement; after `forget_after` the detection restarts.
/// - Without a height above ground (no radio height, and outside the terrain database or without one) there is no statement for
///   `forget_after`. From then on it goes on by speed, by climb, and by the altitude above the last ground that was known, which
///   is remembered for `forget_ground_after` and until the aircraft is higher above it than cruise begins: before that there is
///   no cruise. After it level flight is cruise, and after a descent only once it has lasted for `level_unseen`. An approach
///   remains a descent until the aircraft rests, or is level for so long.
/// - Steps may vary in length. Across a step longer than `longest_step` no condition counts as having held. Time that runs back
///   restarts the detection (a seek restores a saved state instead).
/// - Below `terrain_priority_height_m` no transition may take priority away from terrain, and a phase that gives priority to
///   another aspect is left: the statement is then `unknown`, which shows terrain.
/// - A climb or a go-around that is level for `vertical` below the height of cruise has ended: the statement is `unknown` until
///   the aircraft climbs above the height of the second climb, which is the second climb again, or descends. Level flight that
///   low may be anything: `unknown` contradicts no phase that the bus or a switch states.
///
/// Thread  any, with one state each. Memory  the state. Failure  no statement.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/motion_phase_settings.hpp"
#include "render_core/flight/phase_statement.hpp"

namespace tedavis::flight {

enum class MotionStage : std::uint8_t {
    none,
    ground,
    takeoff_start,
    first_climb,
    second_climb,
    cruise,
    descent,
    initial,
    final,
    landing,
    abort,
    replanning,
    low_flight,  ///< near the ground in a phase that belongs to greater heights, or level after a climb: `unknown`
};

inline constexpr std::size_t kMaxMotionRules = 24;

/// Which altitude `ground_m` is of; none: no ground is remembered.
enum class GroundAltitude : std::uint8_t { none, standard, own_ship };

/// The detector's state; plain data, so that it can be saved and restored.
struct MotionPhaseState {
    struct Timer {
        base::Time since;
        double height_m = 0;  ///< height at the time when the condition began to hold
        bool running = false;
    };
    std::array<Timer, kMaxMotionRules> timers{};
    base::Time last_update;
    base::Time last_complete;  ///< time of the newest update that followed the rules
    base::Time last_speeds;    ///< time of the newest update with speeds
    base::Time last_height;    ///< time of the newest update with a height above ground
    double ground_m = 0;       ///< altitude of the ground that is remembered
    base::Time ground_at;      ///< when it was below
    GroundAltitude ground = GroundAltitude::none;
    bool had_height = false;
    double vertical_speed_mps = 0;  ///< smoothed
    MotionStage stage = MotionStage::none;
    bool any_update = false;
    bool smoothed = false;
};
static_assert(std::is_trivially_copyable_v<MotionPhaseState>);

/// Updates the state at the source time `now`. A second call with the same `now` changes nothing.
[[nodiscard]] PhaseStatement detect_motion_phase(const AircraftState& aircraft, base::Time now,
                                                 const MotionPhaseSettings& settings, MotionPhaseState& state);

}  // namespace tedavis::flight
