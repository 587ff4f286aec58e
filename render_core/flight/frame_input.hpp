/// All that a frame is planned from: the aircraft, the flight phase, the time, and where it has flown.
#pragma once

#include <type_traits>

#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/flight_trail.hpp"

namespace tedavis::flight {

struct FrameInput {
    AircraftState state;  ///< at `time`, with height_above_terrain
    PhaseStatus phase;
    base::Time time;                     ///< of the source
    const FlightTrail* trail = nullptr;  ///< the tracker's own, which goes on; null: nobody keeps one
};
static_assert(std::is_trivially_copyable_v<FrameInput>);

}  // namespace tedavis::flight
