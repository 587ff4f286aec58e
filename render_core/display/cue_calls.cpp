#include "render_core/display/cue_calls.hpp"

#include <cmath>

namespace tedavis::display {
namespace {

using effects::Effect;
using Kind = effects::EffectCall::Kind;

}  // namespace

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

effects::EffectCall cue_call(const CueState& state, bool is_forbidden) noexcept {
    if (is_forbidden) return {Kind::called, ""};  // which the planner says; nothing was built
    if (!state.is_shown) return {Kind::not_called_for, "no element that asks for it is shown"};
    if (state.drawn > 0) return {Kind::called, state.hidden > 0 ? "for want of room only a part of it" : ""};
    if (state.hidden > 0) return {Kind::no_input, "the device has no room left for it"};
    return {Kind::not_called_for, "nothing floats over ground that is known"};
}

void add_asked_cues(const design::DataElementList& elements, effects::EffectSet& asked) noexcept {
    for (const design::DataElement& element : elements)
        for (std::size_t n = 0; n < draw::kCues; ++n)
            if (const auto cue = static_cast<draw::Cue>(n); draw::asks_for(element.cues, cue)) asked.add(effect_of(cue));
}

void project_casters(const design::CasterRoles& casters, double strength, design::DataElementList& elements) noexcept {
    if (!(strength > 0)) return;
    for (design::DataElement& element : elements) {
        const bool is_way =
            element.technique == design::DataTechnique::tube || element.technique == design::DataTechnique::space_time;
        if (is_way && casters.has(element.role)) element.cues.projection = std::fmax(element.cues.projection, strength);
    }
}

void take_out_cue(Effect effect, design::DataElementList& elements) noexcept {
    for (design::DataElement& element : elements) {
        if (effect == Effect::vertical_lines) element.cues.line_spacing_m = 0;
        if (effect == Effect::projections) element.cues.projection = 0;
        if (effect == Effect::curtains) element.cues.curtain = 0;
    }
}

}  // namespace tedavis::display
