/// One source's statement about the flight phase: a phase, or nothing.
#pragma once

#include <type_traits>

#include "render_core/flight/flight_phase.hpp"

namespace tedavis::flight {

struct PhaseStatement {
    FlightPhase phase;
    bool stated = false;  ///< false: the source says nothing and `phase` means nothing
};
static_assert(std::is_trivially_copyable_v<PhaseStatement>);

}  // namespace tedavis::flight
