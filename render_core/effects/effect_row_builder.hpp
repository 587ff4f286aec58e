/// Builds a row of effect_table.cpp; members that are not stated have EffectRow's defaults. A constant expression.
#pragma once

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

class EffectRowBuilder {
    using Design = EffectRow::Design;
    EffectRow row_;
    template <class Value>
    constexpr EffectRowBuilder with(Value EffectRow::*member, Value value) const {
        EffectRowBuilder row = *this;
        row.row_.*member = value;
        return row;
    }

public:
    constexpr EffectRowBuilder(Effect effect, std::string_view name) {
        row_.effect = effect;
        row_.name = name;
    }
    constexpr EffectRowBuilder costs(std::string_view cost) const { return with(&EffectRow::cost, cost); }
    constexpr EffectRowBuilder needs(Need need) const { return with(&EffectRow::need, need); }
    constexpr EffectRowBuilder may_be_forbidden() const { return with(&EffectRow::may_be_forbidden, true); }
    constexpr EffectRowBuilder distracts() const { return with(&EffectRow::distracts, true); }
    constexpr EffectRowBuilder without_terrain() const { return with(&EffectRow::needs_terrain, false); }
    constexpr EffectRowBuilder may_be_given_up() const { return with(&EffectRow::may_be_given_up, true); }
    constexpr EffectRowBuilder changes(Contribution contribution, std::string_view bound) const {
        return with(&EffectRow::contribution, contribution).with(&EffectRow::bound, bound);
    }
    constexpr EffectRowBuilder replaced_by(Effect first, Effect second = Effect::count_) const {
        EffectRowBuilder row = *this;
        row.row_.replacements = {first, second};
        return row;
    }
    constexpr EffectRowBuilder asked_by(std::string_view key, bool (*is_asked)(const Design&)) const {
        return with(&EffectRow::design_key, key).with(&EffectRow::is_asked, is_asked);
    }
    constexpr EffectRowBuilder on_asking(void (*ask)(Design&)) const { return with(&EffectRow::ask, ask); }
    constexpr EffectRowBuilder on_taking_out(void (*take_out)(Design&)) const { return with(&EffectRow::take_out, take_out); }
    constexpr EffectRowBuilder on_replacing(void (*replace)(const Design&, Effect, Design&)) const {
        return with(&EffectRow::replace, replace);
    }
    constexpr EffectRowBuilder applies(EffectRequest (*request)(const EffectFacts&)) const {
        return with(&EffectRow::request, request);
    }
    constexpr operator EffectRow() const { return row_; }
};

}  // namespace tedavis::effects
