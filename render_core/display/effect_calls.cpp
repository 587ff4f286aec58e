#include "render_core/display/effect_calls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tedavis::display {
namespace {

using effects::Effect;
using effects::EffectCall;
using Kind = EffectCall::Kind;

EffectCall sun_call(policy::LightSource light) {
    if (light == policy::LightSource::no_date)
        return {Kind::no_input, "the time of the flight is no date; name sun_utc in the design"};
    if (light == policy::LightSource::sun_too_low) return {Kind::no_input, "the sun stands below 3 degrees"};
    return {Kind::called, ""};
}

EffectCall drape_call(DrapeState drape) {
    if (drape == DrapeState::not_in_database) return {Kind::no_input, "the terrain database has no image"};
    if (drape == DrapeState::not_on_device) return {Kind::no_input, "the device has no room for an image"};
    return {Kind::called, ""};
}

EffectCall ground_call(GroundDataState state) {
    return {state == GroundDataState::shown ? Kind::called : Kind::no_input, reason_of(state)};
}

EffectCall adjacent_call(const EffectFacts& facts) {
    if (facts.decisions.unusual_attitude) return {Kind::not_called_for, kRemovedByPolicy};
    if (facts.adjacent == GroundDataState::not_asked_for) return {Kind::not_called_for, "a free view has no symbology"};
    if (facts.adjacent == GroundDataState::shown && facts.adjacent_maps == 0)
        return {Kind::no_input, "there is no room beside the symbology and the legends"};
    return ground_call(facts.adjacent);
}

EffectCall haze_call(const EffectFacts& facts) {
    if (!(facts.haze_per_m > 0)) return {Kind::not_called_for, "the view is from far away"};
    return {Kind::called, "", haze_bound(facts.haze_per_m, facts.farthest_m)};
}

EffectCall air_call(const EffectFacts& facts) {
    if (!facts.is_near) return {Kind::not_called_for, "the view is from far away"};
    return {Kind::called, "", air_bound(facts.air, facts.farthest_m)};
}

EffectCall focus_call(const EffectFacts& facts) {
    if (!facts.is_near) return {Kind::not_called_for, "the view is from far away"};
    if (facts.focus.blur_px <= 0) return {Kind::called, ""};  // not on this device
    if (!facts.focus.is_known) return {Kind::no_input, "nothing of the role that is in focus is shown"};
    return {Kind::called, "", blur_bound(facts.focus, facts.nearest_m, facts.farthest_m)};
}

constexpr std::string_view kNoFocus = "no focus is anywhere";

EffectCall context_call(const EffectFacts& facts) {
    if (!facts.has_foci) return {Kind::not_called_for, kNoFocus};
    return {Kind::called, ""};
}

EffectCall context_blur_call(const EffectFacts& facts) {
    if (!facts.has_foci) return {Kind::not_called_for, kNoFocus};
    if (facts.reads_distances) return {Kind::no_input, "silhouettes, depth of field or light shafts need the distances instead"};
    return {Kind::called, "", facts.context_blur_px};
}

EffectCall stereo_call(const EffectFacts& facts) {
    if (!facts.is_near) return {Kind::not_called_for, "the view is from far away"};
    return {Kind::called, "", facts.parallax_px};
}

/// From the recovery out of an unusual attitude.
bool distracts(Effect effect) {
    return effect == Effect::depth_of_field || effect == Effect::stereo || effect == Effect::cross_fade ||
           effect == Effect::soft_shadows || effect == Effect::volumetric_light || effect == Effect::focus_ground ||
           effect == Effect::focus_blur || effect == Effect::saliency || effect == Effect::clutter;
}

bool is_removed(Effect effect, const policy::DisplayDecisions& decisions) {
    if (decisions.unusual_attitude && distracts(effect)) return true;
    return !decisions.show_terrain && effect != Effect::panel_lighting;
}

EffectCall clutter_call(const EffectFacts& facts) {
    if (facts.shows_clutter) return {Kind::called, ""};
    if (facts.is_stereo) return {Kind::no_input, "regions of a picture for each eye are not those of the view"};
    if (!facts.has_what_gives_way) return {Kind::not_called_for, "nothing is shown that gives way"};
    return {Kind::called, ""};
}

EffectCall fade_call(double share) {
    if (!(share > 0)) return {Kind::not_called_for, "nothing has changed"};
    return {Kind::called, "", share};
}

EffectCall panel_call(const policy::PanelLight& panel) {
    if (!panel.has_date) return {Kind::no_input, "the time of the flight is no date"};
    const glm::dvec3& white = panel.white;
    const double darkest = std::fmin(white.x, std::fmin(white.y, white.z));
    if (darkest >= 1) return {Kind::not_called_for, "it is day"};
    return {Kind::called, "", 1 - darkest};
}

EffectCall silhouette_call(const EffectFacts& facts) {
    if (facts.is_near) return {Kind::called, ""};
    return {Kind::not_called_for, "seen from so far away depths hardly differ"};
}

EffectCall warning_call(const policy::DisplayDecisions& decisions) {
    if (decisions.show_warning_colors) return {Kind::called, "height is geometric and valid"};
    return {Kind::not_called_for, "not asked for or height not to be trusted"};
}

/// What takes the place of each.
struct StandIns {
    Effect soft_shadows, volumetric_light;
};

void replace_shadows(const design::ShadowSettings& asked, const StandIns& by, design::DesignSettings& possible) {
    if (by.soft_shadows == Effect::projections) project_casters(asked.casters, asked.on_ground, possible.data.elements);
    if (by.volumetric_light == Effect::projections) project_casters(asked.casters, asked.in_air, possible.data.elements);
    design::ShadowSettings& shadows = possible.effects.shadows;
    if (by.soft_shadows != Effect::soft_shadows) shadows.on_ground = 0;
    if (by.volumetric_light == Effect::soft_shadows) shadows.on_ground = std::fmax(shadows.on_ground, asked.in_air);
    if (by.volumetric_light != Effect::volumetric_light) shadows.in_air = 0;
}

/// Blur is another effect.
bool asks_for_context(const design::FocusList& foci) {
    design::FocusTerrain context = terrain_of_context(foci);
    context.blur_px = 0;
    bool asks = context.is_any();
    for (const design::FocusSettings& focus : foci) asks = asks || focus.border.kind != design::FocusBorderKind::none;
    return asks;
}

/// Alpha of the picture has room for distances, or for how sharp it is.
void replace_context_blur(Effect by, design::DesignSettings& possible) {
    if (by == Effect::focus_blur && !reads_distances(possible)) return;
    for (design::FocusSettings& focus : possible.foci) {
        if (by != Effect::count_) focus.terrain = draw::darkened_instead_of_blurred(focus.terrain);
        focus.terrain.blur_px = 0;
    }
}

/// Ground without shades and without lines would say nothing.
void give_lines(design::SketchSettings& sketch) {
    constexpr double kStrength = 0.5;
    const double lines[] = {sketch.silhouettes, sketch.ridges,   sketch.valleys,  sketch.suggestive_contours,
                            sketch.contours,    sketch.hatching, sketch.stippling};
    if (*std::max_element(std::begin(lines), std::end(lines)) <= 0) sketch.contours = kStrength;
}

EffectCall light_shaft_call(const EffectFacts& facts) {
    const bool has_air = facts.asked.has(Effect::aerial_perspective) && facts.air.is_shown;
    const double bound = has_air                ? air_bound(facts.air, facts.farthest_m)
                         : facts.haze_per_m > 0 ? haze_bound(facts.haze_per_m, facts.farthest_m)
                                                : 0;
    return shaft_call(facts.shadows, facts.is_near, bound);
}

}  // namespace

effects::EffectSet asked_effects(const design::DesignSettings& design) noexcept {
    const design::TerrainStyle& style = design.terrain.style;
    effects::EffectSet asked;
    asked.add(Effect::terrain);
    asked.add(Effect::warning_colors);
    if (style.sketch.silhouettes > 0) asked.add(Effect::silhouettes);
    if (style.shade.follows_sun) asked.add(Effect::moving_sun);
    if (style.texture == design::TerrainTexture::image) asked.add(Effect::drape);
    if (design.sky.air.is_shown)
        asked.add(Effect::aerial_perspective);
    else if (design.sky.haze_distance_m > 0)
        asked.add(Effect::haze);
    if (style.grid.spacing_m > 0) asked.add(Effect::surface_grid);
    if (design.data.ground.is_shown) asked.add(Effect::ground_data);
    if (design.data.adjacent.is_shown) asked.add(Effect::adjacent);
    if (design.effects.depth_of_field.blur_px > 0) asked.add(Effect::depth_of_field);
    if (design.effects.lighting != design::PanelLighting::day) asked.add(Effect::panel_lighting);
    if (design.effects.antialiasing) asked.add(Effect::antialiasing);
    if (design.effects.fade_s > 0) asked.add(Effect::cross_fade);
    if (design.effects.stereo.mode != design::StereoMode::none) asked.add(Effect::stereo);
    if (design.effects.shadows.on_ground > 0) asked.add(Effect::soft_shadows);
    if (design.effects.shadows.in_air > 0) asked.add(Effect::volumetric_light);
    if (asks_for_context(design.foci)) asked.add(Effect::focus_ground);
    if (terrain_of_context(design.foci).blur_px > 0) asked.add(Effect::focus_blur);
    if (design.effects.saliency.view != design::SaliencyView::none) asked.add(Effect::saliency);
    if (design.priority.held_clutter() < 1 || design.effects.clutter != design::ClutterView::none) asked.add(Effect::clutter);
    add_asked_cues(design.data.elements, asked);
    return asked;
}

design::DesignSettings with_effect(const design::DesignSettings& design, Effect effect) noexcept {
    constexpr double kFade_s = 0.5, kBlur_px = 4, kTaken = 0.6;
    design::DesignSettings with = design;
    if (effect == Effect::aerial_perspective) with.sky.air.is_shown = true;
    if (effect == Effect::depth_of_field) with.effects.depth_of_field.blur_px = kBlur_px;
    if (effect == Effect::antialiasing) with.effects.antialiasing = true;
    if (effect == Effect::cross_fade) with.effects.fade_s = kFade_s;
    if (effect == Effect::stereo) with.effects.stereo.mode = design::StereoMode::side_by_side;
    if (effect == Effect::soft_shadows) with.effects.shadows.on_ground = kTaken;
    if (effect == Effect::volumetric_light) with.effects.shadows.in_air = kTaken;
    if (effect == Effect::saliency) with.effects.saliency.view = design::SaliencyView::heat;
    if (effect == Effect::clutter) with.effects.clutter = design::ClutterView::regions;
    if (effect == Effect::panel_lighting) with.effects.lighting = design::PanelLighting::night;
    return with;
}

design::DesignSettings without_effect(const design::DesignSettings& design, Effect effect) noexcept {
    design::DesignSettings without = design;
    design::TerrainStyle& style = without.terrain.style;
    switch (effect) {
        case Effect::warning_colors: without.warning_colors = false; break;
        case Effect::silhouettes: style.sketch.silhouettes = 0; break;
        case Effect::ridges: style.sketch.ridges = 0; break;
        case Effect::moving_sun: style.shade.follows_sun = false; break;
        case Effect::drape:
            if (style.texture == design::TerrainTexture::image) style.texture = design::TerrainTexture::plain;
            break;
        case Effect::aerial_perspective: without.sky.air.is_shown = false; break;
        case Effect::haze: without.sky.haze_distance_m = 0; break;
        case Effect::surface_grid:
            style.grid.spacing_m = 0;
            for (design::DataElement& element : without.data.elements) element.grid = false;
            break;
        case Effect::ground_data: without.data.ground.is_shown = false; break;
        case Effect::adjacent: without.data.adjacent.is_shown = false; break;
        case Effect::depth_of_field: without.effects.depth_of_field.blur_px = 0; break;
        case Effect::antialiasing: without.effects.antialiasing = false; break;
        case Effect::panel_lighting: without.effects.lighting = design::PanelLighting::day; break;
        case Effect::cross_fade: without.effects.fade_s = 0; break;
        case Effect::stereo: without.effects.stereo.mode = design::StereoMode::none; break;
        case Effect::vertical_lines:
        case Effect::projections:
        case Effect::curtains: take_out_cue(effect, without.data.elements); break;
        case Effect::soft_shadows: without.effects.shadows.on_ground = 0; break;
        case Effect::volumetric_light: without.effects.shadows.in_air = 0; break;
        case Effect::focus_ground:
            for (design::FocusSettings& focus : without.foci) {
                const double blur_px = focus.terrain.blur_px;
                focus.terrain = {};
                focus.terrain.blur_px = blur_px;
                focus.border = {};
            }
            break;
        case Effect::focus_blur:
            for (design::FocusSettings& focus : without.foci) focus.terrain.blur_px = 0;
            break;
        case Effect::saliency: without.effects.saliency = {}; break;
        case Effect::clutter:
            without.effects.clutter = design::ClutterView::none;
            without.priority.clutter_budget = 1;
            break;
        case Effect::terrain:
        case Effect::fixed_light:
        case Effect::plain_color:
        case Effect::count_: break;
    }
    return without;
}

bool reads_distances(const design::DesignSettings& design) noexcept {
    return design.terrain.style.sketch.silhouettes > 0 || design.effects.depth_of_field.blur_px > 0 ||
           design.effects.shadows.in_air > 0;
}

effects::EffectSet effects_in_reserve(const design::DesignSettings& possible) noexcept {
    effects::EffectSet reserve;
    if (possible.terrain.style.sketch.ridges > 0) reserve.add(Effect::ridges);
    if (draw::ground_focus_kind(possible.foci).foci > 0) reserve.add(Effect::focus_ground);
    reserve.add(Effect::fixed_light);
    return reserve;
}

effects::ReplacementOrder order_of(const design::DesignSettings& design) noexcept {
    const auto order = effects::replacement_order(design.effects.instead);
    return order.ok() ? order.value() : effects::ReplacementOrder();
}

design::DesignSettings possible_design(const design::DesignSettings& design, const effects::DeviceSettings& device) {
    const effects::ReplacementOrder order = order_of(design);
    const auto stands_in = [&](Effect effect) { return possible_effect(effect, device.forbidden, device.capability, order); };
    design::DesignSettings possible = design;
    design::SketchSettings& sketch = possible.terrain.style.sketch;
    if (stands_in(Effect::silhouettes) != Effect::silhouettes) {
        if (stands_in(Effect::silhouettes) == Effect::ridges) sketch.ridges = std::fmax(sketch.ridges, sketch.silhouettes);
        sketch.silhouettes = 0;
    }
    for (const Effect effect :
         {Effect::moving_sun, Effect::drape, Effect::haze, Effect::surface_grid, Effect::ground_data, Effect::adjacent,
          Effect::panel_lighting, Effect::vertical_lines, Effect::projections, Effect::curtains, Effect::focus_ground})
        if (device.forbidden.has(effect)) possible = without_effect(possible, effect);
    for (const Effect effect : {Effect::aerial_perspective, Effect::depth_of_field, Effect::antialiasing, Effect::stereo,
                                Effect::cross_fade, Effect::saliency, Effect::clutter})
        if (stands_in(effect) != effect) possible = without_effect(possible, effect);
    replace_shadows(design.effects.shadows, {stands_in(Effect::soft_shadows), stands_in(Effect::volumetric_light)}, possible);
    replace_context_blur(stands_in(Effect::focus_blur), possible);
    if (terrain_of_context(possible.foci).sketch_outside) give_lines(possible.terrain.style.sketch);
    if (possible.sky.air.is_shown) possible.sky.haze_distance_m = 0;
    return possible;
}

double haze_bound(double haze_per_m, double farthest_m) noexcept { return -std::expm1(-haze_per_m * farthest_m); }

double air_bound(const design::AirSettings& air, double farthest_m) noexcept {
    const earth::Air at_sea = earth::air_of_visibility(air.visibility_m);
    const double per_m = at_sea.molecules_per_m.z + at_sea.aerosol_per_m / earth::kAerosolAlbedo;
    // Light that comes in counts by its root.
    return std::sqrt(-std::expm1(-per_m * farthest_m));
}

draw::FocusRange focus_of(const design::DepthOfField& field, const ElementPlanner& elements, const glm::dvec3& eye) {
    if (field.blur_px <= 0) return {};
    draw::FocusRange focus{true, field.focus_near_m, field.focus_far_m, field.blur_px};
    if (field.focus_role == scene::LayerRole::count) return focus;
    terrain::DepthSpan reach;
    focus.is_known = elements.distances_m(field.focus_role, eye, reach);
    focus.near_m = reach.near_m;
    focus.far_m = reach.far_m;
    return focus;
}

double blur_bound(const draw::FocusRange& focus, double nearest_m, double farthest_m) noexcept {
    const double far = farthest_m > focus.far_m ? 1 - focus.far_m / farthest_m : 0;
    const double near = nearest_m < focus.near_m ? std::fmin(focus.near_m / std::fmax(nearest_m, 1e-3) - 1, 1) : 0;
    return focus.blur_px * std::fmax(far, near);
}

effects::PlanInput effect_calls(const EffectFacts& facts) noexcept {
    effects::PlanInput input;
    input.forbidden = facts.forbidden;
    input.in_reserve = facts.in_reserve;
    input.order = facts.order;
    input.is_forced = facts.is_forced;
    input[Effect::terrain] = {Kind::called, "terrain in view"};
    input[Effect::warning_colors] = warning_call(facts.decisions);
    input[Effect::silhouettes] = silhouette_call(facts);
    input[Effect::moving_sun] = sun_call(facts.light);
    input[Effect::drape] = drape_call(facts.drape);
    input[Effect::aerial_perspective] = air_call(facts);
    input[Effect::haze] = haze_call(facts);
    input[Effect::surface_grid] = {Kind::called, ""};
    input[Effect::ground_data] = ground_call(facts.ground_data);
    input[Effect::adjacent] = adjacent_call(facts);
    input[Effect::depth_of_field] = focus_call(facts);
    input[Effect::stereo] = stereo_call(facts);
    input[Effect::cross_fade] = fade_call(facts.fade_share);
    input[Effect::panel_lighting] = panel_call(facts.panel);
    input[Effect::soft_shadows] = soft_shadow_call(facts.shadows, facts.is_near);
    input[Effect::volumetric_light] = light_shaft_call(facts);
    input[Effect::focus_ground] = context_call(facts);
    input[Effect::focus_blur] = context_blur_call(facts);
    input[Effect::antialiasing] = {Kind::called, "", 1};
    input[Effect::saliency] = {Kind::called, ""};
    input[Effect::clutter] = clutter_call(facts);
    for (std::size_t n = 0; n < draw::kCues; ++n) {
        const Effect effect = effect_of(static_cast<draw::Cue>(n));
        input[effect] = cue_call(facts.cues[n], facts.forbidden.has(effect));
    }
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        if (!facts.asked.has(effect))
            input.calls[n] = {};
        else if (is_removed(effect, facts.decisions))
            input.calls[n] = {Kind::not_called_for, kRemovedByPolicy};
    }
    return input;
}

}  // namespace tedavis::display
