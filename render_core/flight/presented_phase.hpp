/// The phase that the picture follows: the phase in effect, but for flicker.
///
/// A turn after calm (the phase in effect had been the presented one for kCalm) is followed at once, and so is every turn from a
/// phase that shows data or uncertainty to one that shows terrain. Any other is followed when the new phase has lasted kCalm: a
/// switch that bounces beyond its debouncing, or two sources that take turns, turn the picture once, towards terrain, and not
/// again before they agree. The phase itself, and who states it, are on the display and in the record meanwhile.
///
/// Thread  any, one state each. Plain data.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::flight {

struct PresentedPhaseState {
    static constexpr base::Duration kCalm = base::Duration::seconds(2);

    FlightPhase stated;  ///< the last one in effect
    base::Time stated_since;
    FlightPhase presented;
    base::Time presented_since;
    bool after_calm = false;  ///< `stated` came after the presented one had lasted
    bool is_known = false;
};
static_assert(std::is_trivially_copyable_v<PresentedPhaseState>);

/// One step at `now` of the source. Fills `presented` and `presented_since` of the status.
void follow_phase(PhaseStatus& status, base::Time now, PresentedPhaseState& state);

}  // namespace tedavis::flight
