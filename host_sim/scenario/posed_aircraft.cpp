#include "host_sim/scenario/posed_aircraft.hpp"

#include "host_sim/geoid_below.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

constexpr double kFreezing_k = 273.15;

using base::radians;
using flight::Signal;

flight::StatedPose stated_pose(const AircraftPose& pose) {
    return {radians(pose.latitude_deg), radians(pose.longitude_deg), pose.altitude_msl_m,
            radians(pose.heading_deg),  radians(pose.pitch_deg),     radians(pose.roll_deg)};
}

flight::AircraftState posed_aircraft(const AircraftPose& pose, display::Display& display) {
    const flight::StatedPose stated = stated_pose(pose);
    GeoidBelow geoid(display.planner().terrain_database());
    const earth::GeoidUndulation undulation = geoid.at(stated.latitude_rad, earth::wrap_longitude(stated.longitude_rad));
    flight::AircraftState state = flight::posed_state(stated, undulation, pose.time);
    const auto set = [&](Signal signal, double value) { state[signal] = {value, pose.time}; };
    if (pose.flown.seconds > 0) {
        set(Signal::wind_speed, pose.flown.wind_mps);
        set(Signal::wind_direction, radians(pose.flown.wind_from_deg));
        set(Signal::outside_temperature, pose.flown.temperature_c + kFreezing_k);
        set(Signal::horizontal_accuracy, pose.flown.accuracy_m);
        set(Signal::vertical_accuracy, pose.flown.accuracy_m);
    }
    state[Signal::height_above_terrain] = display.planner().height_above_terrain(state.own_ship, pose.time);
    return state;
}

}  // namespace tedavis::host_sim
