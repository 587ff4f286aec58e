#include "host_sim/scenario/posed_aircraft.hpp"

#include "host_sim/geoid_below.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

constexpr double kFreezing_k = 273.15;

using base::radians;
using flight::Signal;

flight::AircraftState posed_aircraft(const AircraftPose& pose, display::Display& display) {
    flight::AircraftState state;
    state.is_posed = true;
    flight::OwnShipEstimate& own = state.own_ship;
    own.position.latitude_rad = radians(pose.latitude_deg);
    own.position.longitude_rad = earth::wrap_longitude(radians(pose.longitude_deg));
    GeoidBelow geoid(display.planner().terrain_database());
    own.position.height =
        earth::to_ellipsoid({pose.altitude_msl_m}, geoid.at(own.position.latitude_rad, own.position.longitude_rad));
    own.at = pose.time;
    own.state = base::SignalState::valid;
    own.height_is_geometric = true;
    const auto set = [&](Signal signal, double value) { state[signal] = {value, pose.time}; };
    set(Signal::latitude, own.position.latitude_rad);
    set(Signal::longitude, own.position.longitude_rad);
    set(Signal::ellipsoid_height, own.position.height.m);
    set(Signal::true_altitude, pose.altitude_msl_m);
    set(Signal::true_heading, earth::wrap_heading(radians(pose.heading_deg)));
    set(Signal::pitch, radians(pose.pitch_deg));
    set(Signal::roll, radians(pose.roll_deg));
    if (pose.flown.seconds > 0) {
        set(Signal::wind_speed, pose.flown.wind_mps);
        set(Signal::wind_direction, radians(pose.flown.wind_from_deg));
        set(Signal::outside_temperature, pose.flown.temperature_c + kFreezing_k);
        set(Signal::horizontal_accuracy, pose.flown.accuracy_m);
        set(Signal::vertical_accuracy, pose.flown.accuracy_m);
    }
    state[Signal::height_above_terrain] = display.planner().height_above_terrain(own, pose.time);
    return state;
}

}  // namespace tedavis::host_sim
