/// Evaluates the rows of effect_table.cpp for a frame's facts: each effect is not requested, applicable, not applicable, or
/// without its input. Pure; any thread.
#pragma once

#include "render_core/effects/effect_facts.hpp"

namespace tedavis::effects {

/// Reason why an effect is left out that belongs to something that may not be shown.
inline constexpr std::string_view kRemovedByPolicy = "removed by the failure policy";

[[nodiscard]] PlanInput effect_requests(const EffectFacts& facts) noexcept;

}  // namespace tedavis::effects
