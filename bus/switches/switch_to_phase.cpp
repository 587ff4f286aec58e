#include "bus/switches/switch_to_phase.hpp"

namespace tedavis::bus {

/// Null where the pattern is impossible, or another one than before and not settled yet.
const SwitchPattern* SwitchToPhase::pattern_of(const State& state, base::Time at) const {
    const SwitchLevels levels = state.debounce.levels(at);
    const std::uint32_t lines = config_.phase_lines();
    const SwitchPattern* pattern = (levels.known & lines) == lines ? config_.find_pattern(levels.high & lines) : nullptr;
    if (pattern == nullptr) return nullptr;
    const bool is_of_before = pattern->phase == state.last_valid.phase;
    return is_of_before || state.debounce.are_settled(lines, at) ? pattern : nullptr;
}

void SwitchToPhase::evaluate(State& state, base::Time at) const {
    state.evaluated = at;
    const SwitchPattern* const pattern = pattern_of(state, at);
    if (pattern != nullptr) {
        state.last_valid = {pattern->phase, pattern->phase.scenario != flight::Scenario::unknown};
    } else if (!state.impossible) {
        state.impossible_since = at;
    }
    state.impossible = pattern == nullptr;
}

void SwitchToPhase::evaluate_waiting_edges(State& state) const {
    if (state.edge_waits) evaluate(state, state.newest_edge);
    state.edge_waits = false;
}

void SwitchToPhase::add(const SwitchEdge& edge) {
    if (edge.line >= config_.lines.size()) return;
    SwitchEdge in_order = edge;
    if (edge.time > state_.newest_edge) {
        evaluate_waiting_edges(state_);
        for (auto next = state_.debounce.next_change(state_.evaluated); next.waiting && next.at < edge.time;
             next = state_.debounce.next_change(state_.evaluated))
            evaluate(state_, next.at);
        state_.newest_edge = edge.time;
    } else {
        in_order.time = state_.newest_edge;
    }
    state_.debounce.add(in_order);
    state_.edge_waits = true;
}

SwitchPhase SwitchToPhase::status(base::Time now) const {
    State at_now = state_;
    evaluate_waiting_edges(at_now);
    for (auto next = at_now.debounce.next_change(at_now.evaluated); next.waiting && next.at <= now;
         next = at_now.debounce.next_change(at_now.evaluated))
        evaluate(at_now, next.at);
    const bool fault = at_now.impossible && now - at_now.impossible_since >= config_.settle;
    return {at_now.last_valid, fault, at_now.debounce.levels(now)};
}

}  // namespace tedavis::bus
