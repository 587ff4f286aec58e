// Which effects a frame has, and what they need.
#include <cmath>

#include "render_core/display/planner/cue_states.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/planner/visible_bounds.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_requests.hpp"

namespace tedavis::display {

namespace {

effects::InputState input_of(GroundDataState state) { return {state == GroundDataState::shown, reason_of(state)}; }

effects::InputState input_of(DrapeState state) {
    if (state == DrapeState::not_in_database) return {false, "the terrain database has no image"};
    if (state == DrapeState::not_on_device) return {false, "the device has no room for an image"};
    return {};
}

double dimming_of(const policy::PanelLight& panel) {
    return 1 - std::fmin(panel.white.x, std::fmin(panel.white.y, panel.white.z));
}

}  // namespace

void FramePlanner::plan_effects() {
    frame_->shadows = plan_shadows();
    frame_->focus = focus_of(look_.effects.depth_of_field, elements_, frame_->picture.camera.view.eye);
    frame_->panel = policy::panel_light(look_.effects, frame_->state.own_ship.position, frame_->flight_time.utc);
    frame_->earlier_share = next_fade_share();
    frame_->design = design_at(memory_->transition.keeps ? memory_->transition.to : memory_->shown).name;
    effects::EffectFacts facts;
    facts.asked = asked();
    facts.forbidden = settings_.device.forbidden;
    facts.in_reserve = effects::effects_in_reserve(look_);
    facts.order = effects::order_of(look_);
    facts.is_forced = effects_are_forced_;
    state_view(facts);
    state_data(facts);
    count();
    frame_->effects = memory_->budget.plan(effects::effect_requests(facts), settings_.device.capability, frame_->counters,
                                           terrain_tolerance(), frame_->time);
    memory_->saliency.plan(frame_->effects.runs(effects::Effect::saliency), frame_->time);
    frame_->saliency = {memory_->saliency.runs(), memory_->saliency.measures()};
    const bool may_hold = facts.has_declutterable_data && !facts.is_stereo;
    memory_->clutter.plan(frame_->effects.runs(effects::Effect::clutter), frame_->time, memory_->shown,
                          may_hold ? look_.priority.held_clutter() : 1);
}

/// States what may be shown, and the view.
void FramePlanner::state_view(effects::EffectFacts& facts) {
    const Camera& camera = frame_->picture.camera;
    SeenSpan seen;
    if (frame_->decisions.show_terrain && !elements_.has_anything())
        seen = {terrain_.nearest_m(camera.view), terrain_.farthest_m(camera.view)};
    facts.shows_terrain = frame_->decisions.show_terrain;
    facts.shows_warning_colors = frame_->decisions.show_warning_colors;
    facts.is_unusual_attitude = frame_->decisions.unusual_attitude;
    facts.is_near = is_near();
    facts.is_stereo = painter_.is_stereo;
    facts.parallax_px = parallax_bound_px(frame_->stereo_cameras, camera.view.focal_px, seen.nearest_m, seen.farthest_m);
    facts.fade_share = frame_->earlier_share;
    facts.light_has_date = frame_->light.source != policy::LightSource::no_date;
    facts.sun_is_too_low = frame_->light.source == policy::LightSource::sun_too_low;
    facts.panel_has_date = frame_->panel.has_date;
    facts.panel_dimming = dimming_of(frame_->panel);
    facts.has_haze = camera.haze_per_m > 0;
    facts.has_air = look_.sky.air.is_shown;
    facts.haze_bound = haze_bound(camera.haze_per_m, seen.farthest_m);
    facts.air_bound = air_bound(look_.sky.air, seen.farthest_m);
    facts.focus_blur_px = frame_->focus.blur_px;
    facts.focus_is_known = frame_->focus.is_known;
    facts.widest_blur_px = blur_bound(frame_->focus, seen);
    facts.has_foci = frame_->foci_plan.foci.is_any();
    facts.context_blur_px = terrain_of_context(look_.foci).blur_px;
    facts.reads_distances = effects::reads_distances(look_);
}

void FramePlanner::state_data(effects::EffectFacts& facts) {
    facts.image = input_of(terrain_.drape(look_.terrain.style));
    facts.ground_data = input_of(frame_->data.ground);
    facts.has_symbology = frame_->maps_beside.state != GroundDataState::not_asked_for;
    facts.maps_beside = input_of(frame_->maps_beside.state);
    facts.maps_drawn = frame_->maps_beside.drawn;
    const CueStates cues = cue_states(elements_.reports());
    facts.vertical_lines = cues[static_cast<std::size_t>(draw::Cue::vertical_lines)];
    facts.projections = cues[static_cast<std::size_t>(draw::Cue::projection)];
    facts.curtains = cues[static_cast<std::size_t>(draw::Cue::curtain)];
    facts.shadows = frame_->shadows.state;
    facts.widest_shadow_px = frame_->shadows.widest_px;
    facts.shadow_in_air = frame_->shadows.in_air;
    facts.shows_clutter = look_.effects.clutter != design::ClutterView::none;
    facts.has_declutterable_data = look_.priority.held_clutter() < 1 && has_declutterable_data();
}

ShadowPlan FramePlanner::plan_shadows() {
    const design::ShadowSettings& settings = look_.effects.shadows;
    if (!settings.is_any() || !frame_->decisions.show_terrain) return {};
    if (!elements_.is_started()) {
        ShadowPlan none;
        none.state = effects::ShadowState::nothing_casts;
        return none;
    }
    const earth::Geodetic eye = earth::from_ecef(frame_->picture.camera.view.eye);
    const terrain::HeightAnswer ground = terrain_.true_height(eye.latitude_rad, eye.longitude_rad);
    const double lowest_m = double{terrain_.database().header().min_height_m};
    const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
    const double ground_m = frame_->picture.camera.view.is_flat() ? frame_->picture.camera.view.flat_msl_m
                            : is_known                            ? ground.height.m
                                                                  : lowest_m;
    return display::plan_shadows(
        {settings, frame_->light, frame_->picture.camera.view, std::fmax(frame_->eye_msl_m - ground_m, 0), undulation_m(eye),
         std::fmin(lowest_m, ground_m), terrain_.nearest_m(frame_->picture.camera.view),
         settings_.device.capability.shadow_map_px, frame_->data.ground == GroundDataState::shown},
        elements_.casters(settings.casters));
}

void FramePlanner::count() {
    const ElementCounters elements = elements_.counters();
    frame_->counters.megapixels = megapixels();
    frame_->counters.is_traced = frame_->decisions.show_terrain && terrain_.is_traced();
    frame_->counters.triangles = frame_->terrain.triangles;
    frame_->counters.maps = frame_->maps_beside.drawn;
    frame_->counters.elements = elements.features;
    frame_->counters.glyphs = elements.glyphs;
}

}  // namespace tedavis::display
