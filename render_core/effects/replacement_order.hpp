/// The replacements of an effect, in order: those of its row (effect_table.hpp), or those that a design states. Pure; any
/// thread.
///
/// A design may omit or reorder the row's replacements; no other effect can be a replacement.
#pragma once

#include <array>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/effects/effect_table.hpp"

namespace tedavis::effects {

using Replacements = std::array<Effect, 2>;  ///< count_ for none; these come last

class ReplacementOrder {
public:
    ReplacementOrder();  ///< the order of the rows
    [[nodiscard]] const Replacements& of(Effect effect) const { return order_[static_cast<std::size_t>(effect)]; }

private:
    friend base::Result<ReplacementOrder, base::FixedString<255>> replacement_order(
        base::Span<const design::InsteadOf> stated) noexcept;
    std::array<Replacements, kEffectCount> order_;
};

/// Makes the order of a design. Fails with one sentence for unknown names and for effects that cannot be replacements.
[[nodiscard]] base::Result<ReplacementOrder, base::FixedString<255>> replacement_order(
    base::Span<const design::InsteadOf> stated) noexcept;

}  // namespace tedavis::effects
