/// An aircraft of which everything is known, level and northbound: beside a free view its place is all that matters.
#pragma once

#include <utility>

#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::test_support {

[[nodiscard]] inline flight::AircraftState aircraft_at(const earth::Geodetic& place, base::Time now = host_sim::kPosedTime) {
    flight::AircraftState state;
    state.own_ship.position = place;
    state.own_ship.at = now;
    state.own_ship.state = base::SignalState::valid;
    state.own_ship.height_is_geometric = true;
    for (const auto& [signal, value] :
         {std::pair{flight::Signal::latitude, place.latitude_rad}, std::pair{flight::Signal::longitude, place.longitude_rad},
          std::pair{flight::Signal::ellipsoid_height, place.height.m}, std::pair{flight::Signal::true_altitude, place.height.m},
          std::pair{flight::Signal::true_heading, 0.0}, std::pair{flight::Signal::pitch, 0.0},
          std::pair{flight::Signal::roll, 0.0}})
        state[signal] = {value, now};
    return state;
}

}  // namespace tedavis::test_support
