#include "render_core/flight/posed_state.hpp"

namespace tedavis::flight {

AircraftState posed_state(const StatedPose& pose, earth::GeoidUndulation undulation, base::Time time) noexcept {
    AircraftState state;
    state.is_posed = true;
    OwnShipEstimate& own = state.own_ship;
    own.position.latitude_rad = pose.latitude_rad;
    own.position.longitude_rad = earth::wrap_longitude(pose.longitude_rad);
    own.position.height = earth::to_ellipsoid({pose.altitude_msl_m}, undulation);
    own.at = time;
    own.state = base::SignalState::valid;
    own.height_is_geometric = true;
    state[Signal::latitude] = {own.position.latitude_rad, time};
    state[Signal::longitude] = {own.position.longitude_rad, time};
    state[Signal::ellipsoid_height] = {own.position.height.m, time};
    state[Signal::true_altitude] = {pose.altitude_msl_m, time};
    state[Signal::true_heading] = {earth::wrap_heading(pose.heading_rad), time};
    state[Signal::pitch] = {pose.pitch_rad, time};
    state[Signal::roll] = {pose.roll_rad, time};
    return state;
}

}  // namespace tedavis::flight
