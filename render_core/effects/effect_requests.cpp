#include "render_core/effects/effect_requests.hpp"

namespace tedavis::effects {
namespace {

bool is_removed(const EffectRow& row, const EffectFacts& facts) {
    if (facts.is_unusual_attitude && row.distracts) return true;
    return !facts.shows_terrain && row.needs_terrain;
}

EffectRequest request_of(const EffectRow& row, const EffectFacts& facts) {
    if (!facts.asked.has(row.effect) || row.request == nullptr) return {};
    if (is_removed(row, facts)) return {EffectRequest::Kind::not_applicable, kRemovedByPolicy};
    return row.request(facts);
}

}  // namespace

PlanInput effect_requests(const EffectFacts& facts) noexcept {
    PlanInput input;
    input.forbidden = facts.forbidden;
    input.in_reserve = facts.in_reserve;
    input.order = facts.order;
    input.is_forced = facts.is_forced;
    for (std::size_t n = 0; n < kEffectCount; ++n) input.requests[n] = request_of(row_of(static_cast<Effect>(n)), facts);
    return input;
}

}  // namespace tedavis::effects
