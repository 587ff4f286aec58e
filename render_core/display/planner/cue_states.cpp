#include "render_core/display/planner/cue_states.hpp"

namespace tedavis::display {

using effects::Effect;

Effect effect_of(draw::Cue cue) noexcept {
    constexpr Effect kEffects[draw::kCues] = {Effect::vertical_lines, Effect::projections, Effect::curtains};
    return kEffects[static_cast<std::size_t>(cue)];
}

CueStates cue_states(const ElementReports& reports) noexcept {
    CueStates states{};
    for (const ElementReport& report : reports) {
        if (report.state != ElementState::shown) continue;
        for (std::size_t n = 0; n < draw::kCues; ++n) {
            if (!draw::asks_for(report.element->cues, static_cast<draw::Cue>(n))) continue;
            states[n].is_shown = true;
            states[n].drawn += report.cues[n].drawn;
            states[n].hidden += report.cues[n].hidden;
        }
    }
    return states;
}

}  // namespace tedavis::display
