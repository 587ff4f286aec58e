// The drawing half of the display: what update() planned gets to the surface.
#include "render_core/display/display.hpp"
#include "render_core/display/effect_notes.hpp"
#include "render_core/display/frame_notes.hpp"
#include "render_core/display/symbology_plan.hpp"
#include "render_core/display/terrain_ground.hpp"

namespace tedavis::display {
void Display::draw(base::Surface& surface) {
    gl_.begin_frame();
    work_ = {};
    gl::bind_surface(gl_, surface);
    if (terrain_.is_started() && data_.take_change() && !terrain_painter_.set_ground_data(gl_, data_.ground()))
        flag("ground_data.missing", record_);
    const bool ready =
        decisions_.show_terrain && terrain_painter_.prepare(gl_, terrain_.seen_from(eye_.view), make_terrain_input(context()));
    prepare_elements();
    if (decisions_.show_terrain && !ready) {
        terrain_failed_ = true;
        give_up_terrain(policy::TerrainSource::failed);
        record_.labels = {};
        put_symbology();
        plan_effects();
    }
    const draw::TerrainDrawResult drawn = paint_measured(surface);
    note_effects({plan_, decisions_, settings_.design, data_plan_.members, maps_beside_.drawn}, record_);
    note_budget(frame_budget_.report(), record_);
    note_elements(elements_.reports(), record_);
    note_clutter();
    note_weights(settings_.design.priority, weights_, record_);
    note_drawn(drawn, settings_.device.budget, record_);
    note_work(work_, record_);
    record_.bytes.uploaded = gl_.frame().uploaded_bytes;
}

draw::TerrainDrawResult Display::paint(base::Surface& surface) {
    const draw::TerrainDrawResult drawn = draw_scene(surface);
    if (plan_.runs(effects::Effect::cross_fade) && fade_.is_started() && !is_unseen_) {
        const WorkScope work(gl_, work_[effects::Effect::cross_fade]);
        fade_.draw(gl_, fade_share_);
    }
    const bool is_whole = last_layer_ == PictureLayer::symbology;
    if (!free_view_active_ && is_whole) draw_symbology(surface);
    if (is_whole) measure(surface);
    if (is_unseen_) return drawn;
    if (is_whole) saliency_.draw(gl_, surface, settings_.design.effects.saliency, work_[effects::Effect::saliency]);
    if (plan_.runs(effects::Effect::panel_lighting) && dimmer_.is_started()) {
        const WorkScope work(gl_, work_[effects::Effect::panel_lighting]);
        dimmer_.draw(gl_, panel_.white);
    }
    return drawn;
}

/// Data on the ground go by the strength that their program draws them with.
void Display::draw_up_to(base::Surface& surface, PictureLayer last) {
    const EffectWorkTable work = work_;
    last_layer_ = last;
    if (last < PictureLayer::uncertainty && terrain_.is_started()) {
        design::DesignSettings bare = settings_.design;
        bare.data.ground.uncertainty.strength = bare.data.ground.overlay.strength = 0;
        if (last < PictureLayer::data) bare.data.ground.opacity = 0;
        terrain_painter_.set_design(gl_, drawn_design(bare, draws_foci_));
    }
    gl_.begin_frame();
    gl::bind_surface(gl_, surface);
    static_cast<void>(paint(surface));
    if (last < PictureLayer::uncertainty && terrain_.is_started())
        terrain_painter_.set_design(gl_, drawn_design(settings_.design, draws_foci_));
    last_layer_ = PictureLayer::symbology;
    work_ = work;
}

draw::TerrainDrawResult Display::draw_scene(base::Surface& surface) {
    if (stereo_.is_started()) return draw_eyes(surface);
    if (turn_ == Turn::keeps && !is_unseen_) {
        const draw::TerrainDrawResult drawn = draw_kept();
        gl::bind_surface(gl_, surface);
        return drawn;  // what was kept covers the surface
    }
    return draw_passes(surface, eye_);
}

draw::TerrainDrawResult Display::draw_eye(const EyePair& pair, draw::EyeSide side) {
    const Eye eye = eye_of(eye_, pair, side, stereo_.margin_px());
    if (shows_elements()) {
        plan_signs(eye, {{}, {}, {}, 2 * stereo_.margin_px(), stereo_.screen_begins_px(side, pair.shift_px), true});
        elements_.stand_at(eye.view.eye);
        prepare_elements();
    }
    return draw_passes(stereo_.target(), eye, side == draw::EyeSide::right);
}

/// One picture is for both where they cannot be told apart; in its own colours then.
draw::TerrainDrawResult Display::draw_eyes(base::Surface& surface) {
    using draw::EyeSide;
    const design::StereoMode mode = settings_.design.effects.stereo.mode;
    if (!plan_.runs(effects::Effect::stereo)) {
        const draw::TerrainDrawResult drawn = draw_eye({}, EyeSide::left);
        const bool has_halves = mode == design::StereoMode::side_by_side;
        stereo_.put(gl_, surface, has_halves ? mode : design::StereoMode::none, EyeSide::left, 0);
        if (has_halves) stereo_.put(gl_, surface, mode, EyeSide::right, 0);
        return drawn;
    }
    const draw::TerrainDrawResult drawn = draw_eye(eyes_, EyeSide::left);
    stereo_.put(gl_, surface, mode, EyeSide::left, eyes_.shift_px);
    const WorkScope work(gl_, work_[effects::Effect::stereo]);
    static_cast<void>(draw_eye(eyes_, EyeSide::right));
    stereo_.put(gl_, surface, mode, EyeSide::right, eyes_.shift_px);
    return drawn;
}

draw::TerrainDrawResult Display::draw_passes(const gl::DrawPlace& place, const Eye& eye, bool has_shadow_map) {
    const SeenTerrain seen = terrain_.seen_from(eye.view);
    const PlannedElements data = elements_.planned();
    const CasterSet casters = elements_.casters(settings_.design.effects.shadows.casters);
    const DrawContext frame = context_of(eye);
    return passes_.draw(
        gl_, place,
        {frame, plan_, terrain_painter_, seen, element_painter_, data, casters, work_, terrain_has_void_, has_shadow_map});
}

void Display::prepare_elements() {
    if (elements_.is_started()) element_painter_.prepare(gl_, elements_.planned());
}

/// In the screen's plane.
void Display::draw_symbology(base::Surface& surface) {
    const bool has_halves = stereo_.is_started() && settings_.design.effects.stereo.mode == design::StereoMode::side_by_side;
    for (const draw::EyeSide side : draw::kEyeSides) {
        if (has_halves) draw::StereoPass::begin_half(gl_, surface, side);
        quad_drawer_.draw(gl_, settings_.width_px, settings_.height_px);
        if (!has_halves) return;
    }
    draw::StereoPass::end_halves(gl_, surface);
}

DrawContext Display::context_of(const Eye& eye) const {
    DrawContext context{settings_.design, decisions_, eye, record_};
    context.aircraft_msl_m = aircraft_msl_m_;
    context.eye_msl_m = eye_msl_m_;
    context.map_share = transition_.map_share();
    context.focus = focus_;
    context.shadows = shadows_;
    context.haze_per_m = plan_.runs(effects::Effect::haze) ? eye_.haze_per_m : 0;
    context.is_free_view = free_view_active_;
    context.last = last_layer_;
    if (draws_foci_) context.foci = &foci_.foci.regions;
    if (terrain_.is_started()) context.heights = height_span(terrain_.database().header());
    return context;
}

}  // namespace tedavis::display
