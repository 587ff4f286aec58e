/// Conditions under which effects are applicable to a frame, for the rows of effect_table.cpp that need more than a comparison.
/// Pure; any thread.
#pragma once

#include "render_core/effects/effect_facts.hpp"

namespace tedavis::effects {

inline constexpr EffectRequest kApplicable{EffectRequest::Kind::applicable, ""};
inline constexpr EffectRequest kFromFarAway{EffectRequest::Kind::not_applicable, "the view is from far away"};

/// Each returns the request of one effect, or of several, for a frame's facts.
[[nodiscard]] EffectRequest always(const EffectFacts&) noexcept;
[[nodiscard]] EffectRequest where(const InputState& input) noexcept;
/// Returns the request for a depth cue. `is_forbidden`: the device forbids it, so no geometry was built, and the planner states
/// the reason.
[[nodiscard]] EffectRequest cue_request(const CueState& state, bool is_forbidden) noexcept;
[[nodiscard]] EffectRequest sun_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest beside_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest focus_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest context_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest context_blur_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest clutter_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest panel_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest soft_shadow_request(const EffectFacts& facts) noexcept;
[[nodiscard]] EffectRequest light_shaft_request(const EffectFacts& facts) noexcept;

}  // namespace tedavis::effects
