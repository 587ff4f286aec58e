/// The states of the depth cues of data elements in a frame. Pure; any thread.
#pragma once

#include <array>

#include "render_core/display/planner/element_report.hpp"
#include "render_core/effects/effect_facts.hpp"

namespace tedavis::display {

using CueStates = std::array<effects::CueState, draw::kCues>;

[[nodiscard]] effects::Effect effect_of(draw::Cue cue) noexcept;
/// Returns the states over all elements that are shown.
[[nodiscard]] CueStates cue_states(const ElementReports& reports) noexcept;

}  // namespace tedavis::display
