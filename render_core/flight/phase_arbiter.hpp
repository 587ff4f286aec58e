/// One flight phase out of what switches, bus and motion state.
///
/// Authority: switch, then CAN message, then motion, then the last phase held, then none (`unknown`). A change within or
/// between sources takes effect once the statement has lasted for its dwell; a switch takes effect at once (it is
/// debounced), and so do the first statement after none and a source's own turn to a phase that shows terrain. A source that
/// stops is bridged by the held phase.
///
/// Thread  any, one state each. Memory  the state. Failure  phase `unknown`, source `none`.
#pragma once

#include <type_traits>

#include "render_core/base/stamped.hpp"
#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/phase_statement.hpp"

namespace tedavis::flight {

struct PhaseInputs {
    PhaseStatement switches;
    bool switch_fault = false;
    base::Stamped<FlightPhase> can;  ///< of message 1830; a phase of `unknown` states nothing
    PhaseStatement motion;           ///< a stated `unknown` counts: it asks for terrain
};

struct PhaseArbiterSettings {
    base::Duration can_timeout = base::Duration::seconds(3);
    base::Duration can_dwell = base::Duration::seconds(1);
    base::Duration motion_dwell = base::Duration::seconds(2);
    base::Duration hold = base::Duration::seconds(10);               ///< since the held phase was last stated
    base::Duration disagreement_dwell = base::Duration::seconds(2);  ///< for the flag to rise and to fall
};

/// Everything that the arbiter remembers; plain, so that it can be saved and restored.
struct PhaseArbiterState {
    FlightPhase phase;                       ///< in effect
    PhaseSource source = PhaseSource::none;  ///< who stated it: never `held`
    base::Time stated_at;                    ///< when anybody last did
    FlightPhase candidate;
    PhaseSource candidate_source = PhaseSource::none;  ///< none: nothing waits
    base::Time candidate_since;
    base::Time disagreement_since;  ///< the flag has been due to change since
    bool disagreement_waits = false;
    bool disagreement = false;
    base::Time last_update;
    bool any_update = false;
};
static_assert(std::is_trivially_copyable_v<PhaseArbiterState>);

/// One update, at `now` of the source. Time that runs back starts anew (a seek restores a saved state instead).
[[nodiscard]] PhaseStatus arbitrate_phase(const PhaseInputs& inputs, base::Time now, const PhaseArbiterSettings& settings,
                                          PhaseArbiterState& state);

}  // namespace tedavis::flight
