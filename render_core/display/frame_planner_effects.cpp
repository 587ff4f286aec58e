// Which effects a frame has, and what they need.
#include <cmath>

#include "render_core/display/effect_calls.hpp"
#include "render_core/display/frame_planner.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {

void FramePlanner::plan_effects() {
    EffectFacts facts{asked(), settings_.device.forbidden, effects_in_reserve(look_), frame_->decisions};
    facts.is_near = is_near();
    facts.light = frame_->light.source;
    facts.drape = terrain_.drape(look_.terrain.style);
    facts.ground_data = frame_->data.ground;
    facts.adjacent = frame_->maps_beside.state;
    facts.adjacent_maps = frame_->maps_beside.drawn;
    facts.haze_per_m = frame_->camera.eye.haze_per_m;
    if (frame_->decisions.show_terrain && !elements_.has_anything()) {
        facts.nearest_m = terrain_.nearest_m(frame_->camera.eye.view);
        facts.farthest_m = terrain_.farthest_m(frame_->camera.eye.view);
    }
    facts.parallax_px = parallax_bound_px(frame_->eyes, frame_->camera.eye.view.focal_px, facts.nearest_m, facts.farthest_m);
    frame_->shadows = plan_shadows();
    facts.shadows = frame_->shadows;
    frame_->focus = focus_of(look_.effects.depth_of_field, elements_, frame_->camera.eye.view.eye);
    facts.focus = frame_->focus;
    frame_->panel = policy::panel_light(look_.effects, frame_->state.own_ship.position, frame_->flight_time.utc);
    facts.panel = frame_->panel;
    facts.cues = cue_states(elements_.reports());
    facts.air = look_.sky.air;
    facts.has_foci = frame_->foci_plan.foci.is_any();
    facts.context_blur_px = terrain_of_context(look_.foci).blur_px;
    facts.reads_distances = reads_distances(look_);
    facts.shows_clutter = look_.effects.clutter != design::ClutterView::none;
    const double held_clutter = look_.priority.held_clutter();
    facts.has_what_gives_way = held_clutter < 1 && has_what_gives_way();
    facts.is_stereo = painter_.is_stereo;
    facts.is_forced = effects_are_forced_;
    frame_->earlier_share = next_fade_share();
    facts.fade_share = frame_->earlier_share;
    frame_->design = design_at(memory_->transition.keeps ? memory_->transition.to : memory_->shown).name;
    facts.order = order_of(look_);
    count();
    frame_->effects = memory_->budget.plan(effect_calls(facts), settings_.device.capability, frame_->counters,
                                           terrain_tolerance(), frame_->time);
    memory_->saliency.plan(frame_->effects.runs(effects::Effect::saliency), frame_->time);
    const bool may_hold = facts.has_what_gives_way && !facts.is_stereo;
    memory_->clutter.plan(frame_->effects.runs(effects::Effect::clutter), frame_->time, memory_->shown,
                          may_hold ? held_clutter : 1);
}

ShadowPlan FramePlanner::plan_shadows() {
    const design::ShadowSettings& settings = look_.effects.shadows;
    if (!settings.is_any() || !frame_->decisions.show_terrain) return {};
    if (!elements_.is_started()) {
        ShadowPlan none;
        none.state = ShadowState::nothing_casts;
        return none;
    }
    const earth::Geodetic eye = earth::from_ecef(frame_->camera.eye.view.eye);
    const terrain::HeightAnswer ground = terrain_.true_height(eye.latitude_rad, eye.longitude_rad);
    const double lowest_m = double{terrain_.database().header().min_height_m};
    const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
    const double ground_m = frame_->camera.eye.view.is_flat() ? frame_->camera.eye.view.flat_msl_m
                            : is_known                        ? ground.height.m
                                                              : lowest_m;
    return display::plan_shadows({settings, frame_->light, frame_->camera.eye.view, std::fmax(frame_->eye_msl_m - ground_m, 0),
                                  undulation_m(eye), std::fmin(lowest_m, ground_m), terrain_.nearest_m(frame_->camera.eye.view),
                                  settings_.device.capability.shadow_map_px, frame_->data.ground == GroundDataState::shown},
                                 elements_.casters(settings.casters));
}

void FramePlanner::count() {
    const ElementCounters elements = elements_.counters();
    frame_->counters.megapixels = settings_.width_px * 1e-6 * settings_.height_px;
    frame_->counters.triangles = frame_->terrain.triangles;
    frame_->counters.maps = frame_->maps_beside.drawn;
    frame_->counters.elements = elements.features;
    frame_->counters.glyphs = elements.glyphs;
}

}  // namespace tedavis::display
