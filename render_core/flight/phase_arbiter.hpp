/// Selects one flight phase from the statements of switches, bus and motion.
///
/// Authority: switch, then CAN message, then motion, then the last phase held, then none (`unknown`). A change within or
/// between sources takes effect once the statement has lasted for its dwell; a switch takes effect at once (it is debounced),
/// and so do the first statement after none and a source's own change to a phase that shows terrain. When a source stops, its
/// phase is held for `hold`.
///
/// Disagreement: a source below the one in effect states another scenario. Sources detect a change of scenario at different
/// times; motion in particular recognises a climb or descent only after it has lasted. A source that still states the scenario
/// before the one in effect (ground before take-off; take-off before cruise and approach; cruise before approach; approach
/// before landing and go-around; go-around before approach and cruise) is late and counts as disagreeing only after an
/// allowance, which restarts when the scenario in effect changes. Any other scenario, such as an approach while the switch is
/// still at cruise, counts as disagreement after a short dwell.
///
/// Thread  any, with one state each. Memory  the state. Failure  phase `unknown`, source `none`.
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
    base::Stamped<FlightPhase> can;  ///< from message 1830; a phase of `unknown` states nothing
    PhaseStatement motion;           ///< a stated `unknown` counts: it requests terrain
};

struct PhaseArbiterSettings {
    base::Duration can_timeout = base::Duration::seconds(3);  ///< on a bus, what its file says
    base::Duration can_dwell = base::Duration::seconds(1);
    base::Duration motion_dwell = base::Duration::seconds(2);
    base::Duration hold = base::Duration::seconds(10);               ///< since the held phase was last stated
    base::Duration disagreement_dwell = base::Duration::seconds(2);  ///< before the flag is raised or cleared, except:
    base::Duration passage_allowance = base::Duration::seconds(20);  ///< twice the time that motion needs for a climb or descent
    base::Duration level_off_allowance = base::Duration::seconds(40);  ///< motion takes 30 s for level flight after a climb
};

/// The arbiter's state; plain data, so that it can be saved and restored.
struct PhaseArbiterState {
    /// A source's disagreement with the scenario in effect.
    struct Difference {
        base::Time since;
        Scenario in_effect = Scenario::unknown;
        bool running = false;
    };
    FlightPhase phase;                       ///< in effect
    PhaseSource source = PhaseSource::none;  ///< its source, never `held`
    base::Time stated_at;                    ///< when a source last stated it
    FlightPhase candidate;
    PhaseSource candidate_source = PhaseSource::none;  ///< none: there is no candidate
    base::Time candidate_since;
    std::array<Difference, 3> differences;  ///< one per source, in order of authority
    base::Time last_contradiction;
    bool disagreement = false;
    base::Time last_update;
    bool any_update = false;
};
static_assert(std::is_trivially_copyable_v<PhaseArbiterState>);

/// Updates the state at the source time `now`. Time that runs back resets the state (a seek restores a saved state instead).
[[nodiscard]] PhaseStatus arbitrate_phase(const PhaseInputs& inputs, base::Time now, const PhaseArbiterSettings& settings,
                                          PhaseArbiterState& state);

}  // namespace tedavis::flight
