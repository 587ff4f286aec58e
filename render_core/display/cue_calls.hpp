/// Cues to the depth of data elements as effects: which of them a design asks for, and what became of them in a frame. Pure; any
/// thread.
#pragma once

#include <array>

#include "render_core/design/shadow_settings.hpp"
#include "render_core/display/element_report.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::display {

struct CueState {
    bool is_shown = false;  ///< an element that asks for it is
    std::uint32_t drawn = 0, hidden = 0;
};
using CueStates = std::array<CueState, draw::kCues>;

[[nodiscard]] effects::Effect effect_of(draw::Cue cue) noexcept;
/// Over all elements that are shown.
[[nodiscard]] CueStates cue_states(const ElementReports& reports) noexcept;
[[nodiscard]] effects::EffectCall cue_call(const CueState& state, bool is_forbidden) noexcept;

void add_asked_cues(const design::DataElementList& elements, effects::EffectSet& asked) noexcept;
/// Ways that would cast shadows are projected onto the ground instead, as strongly at least.
void project_casters(const design::CasterRoles& casters, double strength, design::DataElementList& elements) noexcept;
/// Nothing for other effects.
void take_out_cue(effects::Effect effect, design::DataElementList& elements) noexcept;

}  // namespace tedavis::display
