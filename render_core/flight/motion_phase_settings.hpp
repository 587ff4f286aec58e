/// Thresholds by which the motion of an aircraft tells its flight phase (motion_phase_detector.hpp), by the aircraft's class.
///
/// A light aircraft cruises lower and descends less steeply than a jet; a jet that is level at 600 m is on its approach. A
/// helicopter flies slowly, and a glider that circles in a thermal neither takes off nor goes around.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "render_core/base/time.hpp"

namespace tedavis::flight {

enum class AircraftClass : std::uint8_t { light, jet, helicopter, glider, unstated };
/// Of the classes that a file can state.
inline constexpr std::array<std::string_view, 4> kAircraftClassNames{"light", "jet", "helicopter", "glider"};

/// Metres, m/s, m/s^2. Heights are above the ground below. The defaults are those of an aircraft whose class is not stated.
struct MotionPhaseSettings {
    bool is_enabled = true;           ///< false: motion states no phase
    bool soars = false;               ///< above `cruise_height_m` any flight is cruise: who circles in a thermal climbs and sinks
    double standing_speed_mps = 15;   ///< on the ground below this speed, and
    double ground_height_m = 15;      ///< on the ground below this height, as the radio altimeter measures it
    double standing_climb_mps = 0.5;  ///< where no height is known, within this vertical speed
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
    base::Duration resting = base::Duration::seconds(20);  ///< as standing, where no height is known
    base::Duration lying = base::Duration::seconds(60);    ///< of a glider, which may rest in the wind
    base::Duration go_around = base::Duration::seconds(3);
    base::Duration vertical = base::Duration::seconds(10);  ///< climb, descent and level flight from another phase
    base::Duration level = base::Duration::seconds(30);
    base::Duration level_after_descent = base::Duration::seconds(60);  ///< longer than a landing roll
    base::Duration level_unseen = base::Duration::seconds(180);        ///< after a descent, where no height is known
    base::Duration level_after_replanning = base::Duration::seconds(120);
    base::Duration smoothing = base::Duration::seconds(2);  ///< time constant for the vertical speed
    base::Duration longest_step = base::Duration::seconds(2);
    base::Duration forget_after = base::Duration::seconds(10);
    base::Duration forget_ground_after = base::Duration::seconds(600);  ///< the ground that was below, where no height is known
};

[[nodiscard]] MotionPhaseSettings motion_phase_settings(AircraftClass aircraft) noexcept;

}  // namespace tedavis::flight
