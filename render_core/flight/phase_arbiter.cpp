#include "render_core/flight/phase_arbiter.hpp"

#include <array>

namespace tedavis::flight {
namespace {

struct PhaseVote {
    PhaseSource source = PhaseSource::none;
    PhaseStatement statement;
};
using PhaseVotes = std::array<PhaseVote, 3>;  // in order of authority

PhaseVotes collect(const PhaseInputs& inputs, base::Time now, const PhaseArbiterSettings& settings) {
    const base::FreshnessLimits limits{settings.can_timeout, settings.can_timeout};
    const FlightPhase can = inputs.can.value_or(FlightPhase{});
    const bool can_states = inputs.can.state(now, limits) == base::SignalState::valid && can.scenario != Scenario::unknown;
    return {PhaseVote{PhaseSource::switches, inputs.switches}, PhaseVote{PhaseSource::can, {can, can_states}},
            PhaseVote{PhaseSource::motion, inputs.motion}};
}

/// The statement with the highest authority; source `none` without any statement.
PhaseVote highest(const PhaseVotes& all) {
    for (const PhaseVote& vote : all)
        if (vote.statement.stated) return vote;
    return {};
}

bool speaks(const PhaseVotes& all, PhaseSource source) {
    for (const PhaseVote& vote : all)
        if (vote.source == source) return vote.statement.stated;
    return false;
}

base::Duration dwell_of(const PhaseVote& vote, const PhaseArbiterSettings& settings, const PhaseArbiterState& state) {
    if (vote.source == PhaseSource::switches) return {};
    const bool turns_to_terrain = has_terrain_first(vote.statement.phase) && !has_terrain_first(state.phase);
    if (vote.source == state.source && turns_to_terrain) return {};
    return vote.source == PhaseSource::can ? settings.can_dwell : settings.motion_dwell;
}

void take(const PhaseVote& vote, PhaseArbiterState& state) {
    state.phase = vote.statement.phase;
    state.source = vote.source;
    state.candidate_source = PhaseSource::none;
}

void consider(const PhaseVote& vote, base::Time now, const PhaseArbiterSettings& settings, PhaseArbiterState& state) {
    if (vote.source == state.source && vote.statement.phase == state.phase) {
        state.candidate_source = PhaseSource::none;
        return;
    }
    if (vote.source != state.candidate_source || vote.statement.phase != state.candidate) {
        state.candidate = vote.statement.phase;
        state.candidate_source = vote.source;
        state.candidate_since = now;
    }
    if (now - state.candidate_since >= dwell_of(vote, settings, state)) take(vote, state);
}

/// How long a source may go on stating `stated` after the phase turned to `in_effect`, before it contradicts.
base::Duration allowance(Scenario stated, Scenario in_effect, const PhaseArbiterSettings& settings) {
    struct Passage {
        Scenario from, to;
        bool levels_off;  ///< out of a climb into level flight
    };
    constexpr Passage kPassages[] = {
        {Scenario::ground, Scenario::takeoff, false},    {Scenario::takeoff, Scenario::ground, false},
        {Scenario::takeoff, Scenario::cruise, true},     {Scenario::takeoff, Scenario::approach, false},
        {Scenario::cruise, Scenario::approach, false},   {Scenario::approach, Scenario::ground, false},
        {Scenario::approach, Scenario::takeoff, false},  {Scenario::approach, Scenario::go_around, false},
        {Scenario::go_around, Scenario::approach, true}, {Scenario::go_around, Scenario::cruise, true}};
    for (const Passage& passage : kPassages)
        if (passage.from == stated && passage.to == in_effect)
            return passage.levels_off ? settings.level_off_allowance : settings.passage_allowance;
    return settings.disagreement_dwell;
}

/// Whether a source below the one in effect has stated another scenario for longer than it may.
bool contradicted(const PhaseVotes& all, base::Time now, const PhaseArbiterSettings& settings, PhaseArbiterState& state) {
    const Scenario in_effect = state.phase.scenario;
    const bool has_voted = speaks(all, state.source);
    bool any = false;
    for (std::size_t n = 0; n < all.size(); ++n) {
        const bool below = all[n].source < state.source;  // the enumeration is in order of authority
        const PhaseStatement& statement = all[n].statement;
        const Scenario stated = statement.phase.scenario;
        const bool differs = has_voted && below && statement.stated && stated != Scenario::unknown && stated != in_effect;
        PhaseArbiterState::Difference& difference = state.differences[n];
        if (!differs || !difference.running || difference.in_effect != in_effect) difference = {now, in_effect, differs};
        any = any || (differs && now - difference.since >= allowance(stated, in_effect, settings));
    }
    return any;
}

/// Up at once, because the difference has lasted; down after a dwell.
void update_disagreement(bool contradiction, base::Time now, const PhaseArbiterSettings& settings, PhaseArbiterState& state) {
    if (contradiction) {
        state.disagreement = true;
        state.last_contradiction = now;
    } else if (now - state.last_contradiction > settings.disagreement_dwell) {
        state.disagreement = false;
    }
}

}  // namespace

PhaseStatus arbitrate_phase(const PhaseInputs& inputs, base::Time now, const PhaseArbiterSettings& settings,
                            PhaseArbiterState& state) {
    if (state.any_update && now < state.last_update) state = {};
    state.any_update = true;
    state.last_update = now;
    const PhaseVotes all = collect(inputs, now, settings);
    for (const PhaseVote& vote : all)
        if (vote.statement.stated && vote.statement.phase == state.phase) state.stated_at = now;
    if (now - state.stated_at > settings.hold) {
        state.phase = {};
        state.source = PhaseSource::none;
    }
    const PhaseVote top = highest(all);
    if (top.source == PhaseSource::none) {
        state.candidate_source = PhaseSource::none;
    } else if (state.source == PhaseSource::none) {
        take(top, state);
    } else {
        consider(top, now, settings, state);
    }
    if (top.source != PhaseSource::none && top.statement.phase == state.phase) state.stated_at = now;
    update_disagreement(contradicted(all, now, settings, state), now, settings, state);
    const bool held = state.source != PhaseSource::none && !speaks(all, state.source);
    PhaseStatus status = stated_phase(state.phase, held ? PhaseSource::held : state.source);
    status.switch_fault = inputs.switch_fault;
    status.disagreement = state.disagreement;
    return status;
}

}  // namespace tedavis::flight
