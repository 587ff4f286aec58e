/// One flight phase out of what switches, bus and motion state.
///
/// Authority: switch, then CAN message, then motion, then the last phase held, then none (`unknown`). A change within or
/// between sources takes effect once the statement has lasted for its dwell; a switch takes effect at once (it is
/// debounced), and so do the first statement after none and a source's own turn to a phase that shows terrain. A source that
/// stops is bridged by the held phase.
///
/// Disagreement: a source below the one in effect states another scenario. Sources see a flight pass from one scenario to
/// the next at different times: motion, most of all, believes a climb or descent only after it has lasted. One that still
/// states the scenario before the one in effect (ground before take-off; take-off before cruise and approach; cruise before
/// approach; approach before landing and go-around; go-around before approach and cruise) is late and contradicts only
/// after an allowance, counted anew when the scenario in effect changes. Any other scenario, such as an approach under a
/// switch that was left at cruise, contradicts after a short dwell.
///
/// Thread  any, one state each. Memory  the state. Failure  phase `unknown`, source `none`.
#pragma once

#include <array>
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
    base::Duration hold = base::Duration::seconds(10);                 ///< since the held phase was last stated
    base::Duration disagreement_dwell = base::Duration::seconds(2);    ///< for the flag to rise and to fall, but for:
    base::Duration passage_allowance = base::Duration::seconds(20);    ///< twice what motion takes for a climb or descent
    base::Duration level_off_allowance = base::Duration::seconds(40);  ///< level flight takes motion 30 s, out of a climb
};

/// Everything that the arbiter remembers; plain, so that it can be saved and restored.
struct PhaseArbiterState {
    /// What a source states against the scenario in effect.
    struct Difference {
        base::Time since;
        Scenario in_effect = Scenario::unknown;
        bool running = false;
    };
    FlightPhase phase;                       ///< in effect
    PhaseSource source = PhaseSource::none;  ///< who stated it: never `held`
    base::Time stated_at;                    ///< when anybody last did
    FlightPhase candidate;
    PhaseSource candidate_source = PhaseSource::none;  ///< none: nothing waits
    base::Time candidate_since;
    std::array<Difference, 3> differences;  ///< of the sources in order of authority
    base::Time last_contradiction;
    bool disagreement = false;
    base::Time last_update;
    bool any_update = false;
};
static_assert(std::is_trivially_copyable_v<PhaseArbiterState>);

/// One update, at `now` of the source. Time that runs back starts anew (a seek restores a saved state instead).
[[nodiscard]] PhaseStatus arbitrate_phase(const PhaseInputs& inputs, base::Time now, const PhaseArbiterSettings& settings,
                                          PhaseArbiterState& state);

}  // namespace tedavis::flight
