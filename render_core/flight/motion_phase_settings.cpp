#include "render_core/flight/motion_phase_settings.hpp"

#include <limits>

namespace tedavis::flight {
namespace {

constexpr double kLowestCruise_m = 500;  // above the height below which terrain keeps its priority

MotionPhaseSettings of_light() {
    MotionPhaseSettings s;
    s.cruise_height_m = kLowestCruise_m;
    s.level_mps = 1;
    s.descent_mps = 1.5;
    s.initial_height_m = 450;
    s.level_unseen = base::Duration::seconds(120);
    s.vertical = base::Duration::seconds(20);  // in the Alps the air rises and sinks for longer than ten seconds
    return s;
}

MotionPhaseSettings of_jet() {
    MotionPhaseSettings s;
    s.takeoff_speed_mps = 40;
    s.takeoff_run_speed_mps = 25;
    s.level_after_descent = base::Duration::seconds(120);
    return s;
}

/// It hovers and flies slowly.
MotionPhaseSettings of_helicopter() {
    MotionPhaseSettings s;
    s.standing_speed_mps = 3;
    s.standing_climb_mps = 0.2;
    s.takeoff_speed_mps = 15;
    s.takeoff_run_speed_mps = 10;
    s.cruise_height_m = kLowestCruise_m;
    s.initial_height_m = 300;
    s.final_height_m = 150;
    s.replanning_height_m = 300;
    s.level = base::Duration::seconds(15);
    s.level_after_descent = base::Duration::seconds(30);
    s.level_unseen = base::Duration::seconds(60);
    s.standing = base::Duration::seconds(20);
    return s;
}

/// Its own sink is no descent, and lift no go-around.
MotionPhaseSettings of_glider() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    MotionPhaseSettings s;
    s.soars = true;
    s.standing_speed_mps = 2;
    s.takeoff_speed_mps = 5;
    s.takeoff_run_speed_mps = 4;
    s.second_climb_height_m = 150;
    s.cruise_height_m = kLowestCruise_m;
    s.descent_mps = kNever;
    s.approach_descent_mps = 0.3;
    s.initial_height_m = 200;
    s.final_height_m = 80;
    s.go_around_climb_mps = kNever;
    s.standing = base::Duration::seconds(20);
    return s;
}

}  // namespace

MotionPhaseSettings motion_phase_settings(AircraftClass aircraft) noexcept {
    switch (aircraft) {
        case AircraftClass::unstated: break;
        case AircraftClass::light: return of_light();
        case AircraftClass::jet: return of_jet();
        case AircraftClass::helicopter: return of_helicopter();
        case AircraftClass::glider: return of_glider();
    }
    return {};
}

}  // namespace tedavis::flight
