/// What takes an effect's place, in order: that of its row (effect_table.hpp), or what a design says instead. Pure; any thread.
///
/// A design may leave out what the row names and put it in another order; nothing else can take the place of an effect.
#pragma once

#include <array>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/effects/effect_table.hpp"

namespace tedavis::effects {

using Replacements = std::array<Effect, 2>;  ///< count_ for none, which come last

class ReplacementOrder {
public:
    ReplacementOrder();  ///< the rows'
    [[nodiscard]] const Replacements& of(Effect effect) const { return order_[static_cast<std::size_t>(effect)]; }

private:
    friend base::Result<ReplacementOrder, base::FixedString<255>> replacement_order(
        base::Span<const design::InsteadOf> stated) noexcept;
    std::array<Replacements, kEffectCount> order_;
};

/// Refused in one sentence: names that are no effects, and effects that cannot take the place of that one.
[[nodiscard]] base::Result<ReplacementOrder, base::FixedString<255>> replacement_order(
    base::Span<const design::InsteadOf> stated) noexcept;

}  // namespace tedavis::effects
