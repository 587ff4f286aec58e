/// Detects the flight phase from the aircraft's motion, for when neither switches nor bus state one.
///
/// An online state machine on ground speed, vertical speed and height above ground; each transition requires its condition to
/// hold without interruption for a certain time, and there is hysteresis between entering and leaving a phase. Phases follow
/// thesis section 3.1; the thresholds are settings.
///
/// - Missing inputs (no valid speed, vertical speed or height) give no statement; after `forget_after` the detection restarts.
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
#include "render_core/flight/phase_statement.hpp"

namespace tedavis::flight {

/// Metres, m/s, m/s^2. Heights are above the ground below.
struct MotionPhaseSettings {
    double standing_speed_mps = 15;            ///< on the ground below this speed
    double ground_height_m = 15;               ///< on the ground below this height, as the radio altimeter measures it
    double terrain_height_margin_m = 15;       ///< added to heights near the ground that come from the terrain database
    double takeoff_speed_mps = 30;             ///< a take-off run above this, or
    double takeoff_run_speed_mps = 20;         ///< above this with
    double takeoff_acceleration_mps2 = 1;      ///< this much acceleration along the body
    double lift_off_height_m = 11;             ///< 35 ft: first climb
    double second_climb_height_m = 300;        ///< 1000 ft: second climb
    double climb_mps = 1.5;                    ///< climbing above this vertical speed
    double level_mps = 1.5;                    ///< level within this vertical speed, and until
    double level_hysteresis_mps = 0.5;         ///< this much beyond it
    double cruise_height_m = 1500;             ///< cruise is level above this
    double descent_mps = 2.5;                  ///< descent from height faster than this
    double approach_descent_mps = 1;           ///< descent below the initial approach height faster than this
    double initial_height_m = 900;             ///< initial approach below this
    double final_height_m = 300;               ///< final approach below this
    double not_climbing_mps = 0.5;             ///< final approach and landing only below this vertical speed
    double go_around_climb_mps = 2.5;          ///< go-around, and a climb after level flight, faster than this
    double go_around_rise_m = 30;              ///< and has gained this height since it began to
    double replanning_height_m = 500;          ///< re-planning above this, after a go-around
    double terrain_priority_height_m = 457.2;  ///< 1500 ft: terrain keeps its priority below this
    double radio_height_limit_m = 750;         ///< a radio altimeter is believed below this

    base::Duration brief = base::Duration::seconds(1);  ///< lift-off, touchdown, low flight
    base::Duration usual = base::Duration::seconds(2);  ///< between consecutive phases
    base::Duration standing = base::Duration::seconds(3);
    base::Duration go_around = base::Duration::seconds(3);
    base::Duration vertical = base::Duration::seconds(10);  ///< climb, descent and level flight from another phase
    base::Duration level = base::Duration::seconds(30);
    base::Duration level_after_replanning = base::Duration::seconds(120);
    base::Duration smoothing = base::Duration::seconds(2);  ///< time constant for the vertical speed
    base::Duration longest_step = base::Duration::seconds(2);
    base::Duration forget_after = base::Duration::seconds(10);
};

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

/// The detector's state; plain data, so that it can be saved and restored.
struct MotionPhaseState {
    struct Timer {
        base::Time since;
        double height_m = 0;  ///< height at the time when the condition began to hold
        bool running = false;
    };
    std::array<Timer, kMaxMotionRules> timers{};
    base::Time last_update;
    base::Time last_complete;       ///< time of the newest update with all inputs
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
