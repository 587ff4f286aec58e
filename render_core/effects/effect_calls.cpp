#include "render_core/effects/effect_calls.hpp"

namespace tedavis::effects {
namespace {

bool is_removed(const EffectRow& row, const EffectFacts& facts) {
    if (facts.is_unusual_attitude && row.distracts) return true;
    return !facts.shows_terrain && row.needs_terrain;
}

EffectCall call_of(const EffectRow& row, const EffectFacts& facts) {
    if (!facts.asked.has(row.effect) || row.call == nullptr) return {};
    if (is_removed(row, facts)) return {EffectCall::Kind::not_called_for, kRemovedByPolicy};
    return row.call(facts);
}

}  // namespace

PlanInput effect_calls(const EffectFacts& facts) noexcept {
    PlanInput input;
    input.forbidden = facts.forbidden;
    input.in_reserve = facts.in_reserve;
    input.order = facts.order;
    input.is_forced = facts.is_forced;
    for (std::size_t n = 0; n < kEffectCount; ++n) input.calls[n] = call_of(row_of(static_cast<Effect>(n)), facts);
    return input;
}

}  // namespace tedavis::effects
