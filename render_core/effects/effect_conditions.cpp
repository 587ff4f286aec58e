#include "render_core/effects/effect_conditions.hpp"

namespace tedavis::effects {

using Kind = EffectRequest::Kind;

EffectRequest always(const EffectFacts&) noexcept { return kApplicable; }

EffectRequest where(const InputState& input) noexcept { return {input.is_there ? Kind::applicable : Kind::no_input, input.why}; }

EffectRequest cue_request(const CueState& state, bool is_forbidden) noexcept {
    if (is_forbidden) return kApplicable;
    if (!state.is_shown) return {Kind::not_applicable, "no element that asks for it is shown"};
    if (state.drawn > 0) return {Kind::applicable, state.hidden > 0 ? "for want of room only a part of it" : ""};
    if (state.hidden > 0) return {Kind::no_input, "the device has no room left for it"};
    return {Kind::not_applicable, "nothing floats over ground that is known"};
}

EffectRequest sun_request(const EffectFacts& facts) noexcept {
    if (!facts.light_has_date) return {Kind::no_input, "the time of the flight is no date; name sun_utc in the design"};
    if (facts.sun_is_too_low) return {Kind::no_input, "the sun stands below 3 degrees"};
    return kApplicable;
}

EffectRequest beside_request(const EffectFacts& facts) noexcept {
    if (!facts.has_symbology) return {Kind::not_applicable, "a free view has no symbology"};
    if (facts.maps_beside.is_there && facts.maps_drawn == 0)
        return {Kind::no_input, "there is no room beside the symbology and the legends"};
    return where(facts.maps_beside);
}

EffectRequest focus_request(const EffectFacts& facts) noexcept {
    if (!facts.is_near) return kFromFarAway;
    if (facts.focus_blur_px <= 0) return kApplicable;  // not on this device
    if (!facts.focus_is_known) return {Kind::no_input, "nothing of the role that is in focus is shown"};
    return {Kind::applicable, "", facts.widest_blur_px};
}

EffectRequest context_request(const EffectFacts& facts) noexcept {
    if (!facts.has_foci) return {Kind::not_applicable, "no focus is anywhere"};
    return kApplicable;
}

EffectRequest context_blur_request(const EffectFacts& facts) noexcept {
    const EffectRequest request = context_request(facts);
    if (request.kind != Kind::applicable) return request;
    if (facts.reads_distances) return {Kind::no_input, "silhouettes, depth of field or light shafts need the distances instead"};
    return {Kind::applicable, "", facts.context_blur_px};
}

EffectRequest clutter_request(const EffectFacts& facts) noexcept {
    if (facts.shows_clutter) return kApplicable;
    if (facts.is_stereo) return {Kind::no_input, "regions of a picture for each eye are not those of the view"};
    if (!facts.has_declutterable_data) return {Kind::not_applicable, "nothing is shown that gives way"};
    return kApplicable;
}

EffectRequest panel_request(const EffectFacts& facts) noexcept {
    if (!facts.panel_has_date) return {Kind::no_input, "the time of the flight is no date"};
    if (facts.panel_dimming <= 0) return {Kind::not_applicable, "it is day"};
    return {Kind::applicable, "", facts.panel_dimming};
}

EffectRequest soft_shadow_request(const EffectFacts& facts) noexcept {
    if (!facts.is_near) return kFromFarAway;
    switch (facts.shadows) {
        case ShadowState::not_asked_for: return kApplicable;  // not on this device
        case ShadowState::sun_too_low: return {Kind::not_applicable, "the sun stands below 3 degrees"};
        case ShadowState::values_on_ground: return {Kind::not_applicable, "the colours of the ground are values"};
        case ShadowState::nothing_casts: return {Kind::not_applicable, "nothing over the ground casts a shadow into the view"};
        case ShadowState::cast: break;
    }
    return {Kind::applicable, "", facts.widest_shadow_px};
}

EffectRequest light_shaft_request(const EffectFacts& facts) noexcept {
    EffectRequest request = soft_shadow_request(facts);
    if (request.kind != Kind::applicable || facts.shadows != ShadowState::cast) return request;
    const bool has_air = facts.asked.has(Effect::aerial_perspective) && facts.has_air;
    const double bound = has_air ? facts.air_bound : facts.has_haze ? facts.haze_bound : 0;
    if (!(bound > 0)) return {Kind::not_applicable, "there is neither air nor haze that scatters light"};
    request.bound = facts.shadow_in_air * bound;
    return request;
}

}  // namespace tedavis::effects
