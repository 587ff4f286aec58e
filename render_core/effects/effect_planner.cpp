#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {
namespace {

bool is_possible(Effect effect, const EffectSet& forbidden, const DeviceCapability& device) {
    return !forbidden.has(effect) && has(device, row_of(effect).need);
}

/// What takes the place of an effect that is too dear: the first of its list that a running display can turn to.
Effect reserve_of(Effect effect, const PlanInput& input, const DeviceCapability& device) {
    for (const Effect replacement : input.order.of(effect))
        if (replacement != Effect::count_ && is_possible(replacement, input.forbidden, device) &&
            input.in_reserve.has(replacement) && !input.too_costly.has(replacement))
            return replacement;
    return Effect::count_;
}

PlannedEffect plan_request(Effect effect, const PlanInput& input, const DeviceCapability& device) {
    using Kind = EffectRequest::Kind;
    const EffectRequest& request = input.requests[static_cast<std::size_t>(effect)];
    const EffectSet& forbidden = input.forbidden;
    PlannedEffect planned;
    if (request.kind == Kind::not_asked_for) return planned;
    planned.state = PlanState::skipped;
    planned.reason = request.why;
    if (request.kind == Kind::not_applicable) return planned;
    // What stands for it when it lacks its input must be something else, even where the device could do it.
    EffectSet excluded = forbidden;
    if (request.kind == Kind::no_input) excluded.add(effect);
    const Effect stands_in = possible_effect(effect, excluded, device, input.order);
    if (forbidden.has(effect))
        planned.reason = "forbidden by the device's file";
    else if (request.kind == Kind::applicable && stands_in != effect)
        planned.reason = lack_of(row_of(effect).need);
    if (stands_in == Effect::count_) return planned;
    planned.state = stands_in == effect ? PlanState::run : PlanState::replaced;
    if (stands_in != effect) planned.replaced_by = stands_in;
    if (planned.state == PlanState::run && planned.reason.empty()) planned.reason = "asked for by the design";
    return planned;
}

/// After what the device can do: its reasons go before those of the time.
void give_up_if_too_costly(Effect effect, const PlanInput& input, const DeviceCapability& device, PlannedEffect& planned) {
    if (planned.state != PlanState::run || !input.too_costly.has(effect)) return;
    const Effect reserve = reserve_of(effect, input, device);
    planned.state = reserve == Effect::count_ ? PlanState::skipped : PlanState::replaced;
    planned.reason = "the time does not suffice";
    planned.replaced_by = reserve;
}

bool is_unseen(const PlanInput& input, const FramePlan& plan, Effect effect, double color_left) {
    if (input.is_forced || plan[effect].state != PlanState::run) return false;
    const double bound = input.requests[static_cast<std::size_t>(effect)].bound;
    const Contribution contribution = row_of(effect).contribution;
    return contribution == Contribution::color      ? bound <= color_left
           : contribution == Contribution::geometry ? bound < kUnseenPixels
                                                    : bound == 0;
}

/// The running effect with the smallest bound that may be left out unseen; count_ for none.
Effect least_seen(const PlanInput& input, const FramePlan& plan, double color_left) {
    Effect least = Effect::count_;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        const double bound = input.requests[n].bound;
        if (!(bound < smallest) || !is_unseen(input, plan, effect, color_left)) continue;
        least = effect;
        smallest = bound;
    }
    return least;
}

}  // namespace

Effect possible_effect(Effect effect, const EffectSet& forbidden, const DeviceCapability& device,
                       const ReplacementOrder& order) noexcept {
    if (is_possible(effect, forbidden, device)) return effect;
    for (const Effect replacement : order.of(effect))
        if (replacement != Effect::count_ && is_possible(replacement, forbidden, device)) return replacement;
    return Effect::count_;
}

bool FramePlan::runs(Effect effect) const {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const PlannedEffect& planned = effects_[n];
        if (planned.state == PlanState::run && static_cast<Effect>(n) == effect) return true;
        if (planned.state == PlanState::replaced && planned.replaced_by == effect) return true;
    }
    return false;
}

double FramePlan::unseen_color() const {
    double sum = 0;
    for (std::size_t n = 0; n < kEffectCount; ++n)
        if (row_of(static_cast<Effect>(n)).contribution == Contribution::color) sum += effects_[n].bound;
    return sum;
}

FramePlan plan_effects(const PlanInput& input, const DeviceCapability& device) noexcept {
    FramePlan plan;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        plan.effects_[n] = plan_request(effect, input, device);
        give_up_if_too_costly(effect, input, device, plan.effects_[n]);
    }
    // From the smallest bound on, so that as many as possible stay under the one sum.
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const Effect effect = least_seen(input, plan, kUnseenColor - plan.unseen_color());
        if (effect == Effect::count_) break;
        PlannedEffect& unseen = plan.effects_[static_cast<std::size_t>(effect)];
        unseen = {PlanState::skipped, "too small to be seen", Effect::count_,
                  input.requests[static_cast<std::size_t>(effect)].bound};
    }
    return plan;
}

}  // namespace tedavis::effects
