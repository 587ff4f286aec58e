#include "render_core/flight/presented_phase.hpp"

namespace tedavis::flight {
namespace {

void begin(FlightPhase phase, base::Time now, PresentedPhaseState& state) { state = {phase, now, phase, now, true, true}; }

void note(FlightPhase phase, base::Time now, PresentedPhaseState& state) {
    if (phase == state.stated) return;
    state.after_calm = state.stated == state.presented && now - state.stated_since >= PresentedPhaseState::kCalm;
    state.stated = phase;
    state.stated_since = now;
}

bool may_turn(base::Time now, const PresentedPhaseState& state) {
    const bool towards_terrain = has_terrain_first(state.stated) && !has_terrain_first(state.presented);
    return state.after_calm || towards_terrain || now - state.stated_since >= PresentedPhaseState::kCalm;
}

}  // namespace

void follow_phase(PhaseStatus& status, base::Time now, PresentedPhaseState& state) {
    const bool runs_back = state.is_known && now < state.stated_since;
    if (!state.is_known || runs_back) begin(status.phase, now, state);
    note(status.phase, now, state);
    if (state.stated != state.presented && may_turn(now, state)) {
        state.presented = state.stated;
        state.presented_since = now;
    }
    status.presented = state.presented;
    status.presented_since = state.presented_since;
}

}  // namespace tedavis::flight
