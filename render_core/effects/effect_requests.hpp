/// What a frame's facts say to every effect, for the planner of effects: not asked for, applicable, not applicable, or without
/// its input, by the rows of effect_table.cpp. Pure; any thread.
#pragma once

#include "render_core/effects/effect_facts.hpp"

namespace tedavis::effects {

/// Why an effect of what may not be shown now is left out.
inline constexpr std::string_view kRemovedByPolicy = "removed by the failure policy";

[[nodiscard]] PlanInput effect_requests(const EffectFacts& facts) noexcept;

}  // namespace tedavis::effects
