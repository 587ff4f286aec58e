/// The input of a frame: the aircraft, the flight phase, the time and the flight trail.
#pragma once

#include <optional>
#include <type_traits>

#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/flight_trail.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::flight {

struct FrameInput {
    AircraftState state;  ///< at `time`, with height_above_terrain
    PhaseStatus phase;
    base::Time time;                     ///< the source's time
    const FlightTrail* trail = nullptr;  ///< the tracker's, updated by its later steps; null: there is none
    std::optional<LegendShow> legend{};  ///< what the panel or the bus asks for; nothing: neither does
};
static_assert(std::is_trivially_copyable_v<FrameInput>);

}  // namespace tedavis::flight
