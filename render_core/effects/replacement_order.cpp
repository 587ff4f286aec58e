#include "render_core/effects/replacement_order.hpp"

#include <initializer_list>

namespace tedavis::effects {
namespace {

using Message = base::FixedString<255>;

Message joined(std::initializer_list<std::string_view> parts) {
    Message message;
    for (std::string_view part : parts) message.append(part);
    return message;
}

bool can_replace(Effect effect, Effect replacement) {
    for (const Effect known : row_of(effect).replacements)
        if (known == replacement) return true;
    return false;
}

}  // namespace

ReplacementOrder::ReplacementOrder() : order_{} {
    for (std::size_t n = 0; n < kEffectCount; ++n) order_[n] = row_of(static_cast<Effect>(n)).replacements;
}

base::Result<ReplacementOrder, Message> replacement_order(base::Span<const design::InsteadOf> stated) noexcept {
    ReplacementOrder order;
    for (const design::InsteadOf& one : stated) {
        const Effect effect = effect_of(one.effect.view());
        if (effect == Effect::count_)
            return base::fail(joined({"[effects.instead] ", one.effect.view(), ": no effect has this name"}));
        Replacements& list = order.order_[static_cast<std::size_t>(effect)];
        list.fill(Effect::count_);
        std::size_t count = 0;
        for (const auto& name : one.instead) {
            const Effect replacement = effect_of(name.view());
            if (replacement == Effect::count_ || !can_replace(effect, replacement))
                return base::fail(joined({"[effects.instead] ", one.effect.view(), ": '", name.view(),
                                          "' cannot take its place; render_core/effects/README.md lists what can"}));
            list[count++] = replacement;
        }
    }
    return order;
}

}  // namespace tedavis::effects
