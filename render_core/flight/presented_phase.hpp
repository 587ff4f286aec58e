/// The phase that the picture follows: the phase in effect without flicker.
///
/// A change is followed at once where the presented phase had been in effect for kCalm before, or where it leads from a phase
/// that shows data or uncertainty to one that shows terrain. Any other change is followed when the new phase has lasted kCalm.
/// So a switch that bounces beyond its debouncing, or two alternating sources, change the picture once, towards terrain, and
/// not again before they agree. Meanwhile the display and the record state the phase in effect and its source.
///
/// Thread  any, with one state each. Plain data.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::flight {

struct PresentedPhaseState {
    static constexpr base::Duration kCalm = base::Duration::seconds(2);

    FlightPhase stated;  ///< the phase in effect at the last step
    base::Time stated_since;
    FlightPhase presented;
    base::Time presented_since;
    bool after_calm = false;  ///< `stated` began after the presented phase had lasted kCalm
    bool is_known = false;
};
static_assert(std::is_trivially_copyable_v<PresentedPhaseState>);

/// Steps the state at the source time `now` and fills `presented` and `presented_since` of the status.
void follow_phase(PhaseStatus& status, base::Time now, PresentedPhaseState& state);

}  // namespace tedavis::flight
