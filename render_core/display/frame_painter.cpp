#include "render_core/display/frame_painter.hpp"

#include "render_core/design/weighted_design.hpp"

namespace tedavis::display {

base::Error FramePainter::open(base::Surface& surface, const effects::DeviceSettings& device, base::ProgramStore* programs) {
    gl_.use_programs(programs);
    const auto opened = gl_.open(surface, device.capability);
    return opened.ok() ? base::Error{} : opened.error();
}

base::Error FramePainter::start(const PainterStart& start, const FramePlanner& planner, DisplayMemory& memory) {
    device_ = &start.device;
    width_px_ = start.width_px;
    height_px_ = start.height_px;
    look_key_ = planner.look_key();
    base::BudgetTable& budget = start.device.budget;
    bool fades = false, dims = false, shows_map = false, shows_heat = false;
    for (const draw::DrawnDesign& drawn : start.designs) {
        const design::ViewEffects& effects = drawn.design->effects;
        fades = fades || effects.fade_s > 0;
        dims = dims || effects.lighting != design::PanelLighting::day;
        shows_map = shows_map || effects.saliency.view == design::SaliencyView::map;
        shows_heat = shows_heat || effects.saliency.view == design::SaliencyView::heat;
    }
    const std::uint32_t margin_px = start.stereo_margin_px;
    if (margin_px > 0)
        if (base::Error error = stereo_.start(gl_, budget, width_px_, height_px_, margin_px)) return error;
    if (fades && margin_px == 0)
        if (base::Error error = fade_.start(gl_, budget, width_px_, height_px_)) return error;
    if (base::Error error = passes_.start(gl_, start.device, start.designs, width_px_ + 2 * margin_px, height_px_)) return error;
    if (shows_map || shows_heat)
        if (base::Error error = saliency_.start(gl_, budget, width_px_, height_px_, shows_map, shows_heat)) return error;
    if (start.clutter.measures())
        if (base::Error error = edges_.start(gl_, budget, memory.picture_edges(), width_px_, height_px_, start.clutter.shows()))
            return error;
    if (dims)
        if (base::Error error = dimmer_.start(gl_, budget)) return error;
    return symbology_.start(gl_, budget, planner.symbology());
}

base::Error FramePainter::start_terrain(const PainterStart& start, TerrainPlanner& terrain, DisplayMemory& memory,
                                        base::Workers* workers) {
    if (!terrain.is_started()) return {};
    const draw::TracePlace traced{workers, &memory.traced_terrain(), width_px_ + 2 * start.stereo_margin_px, height_px_};
    has_terrain_ = true;
    return terrain_.start(gl_, terrain, start.designs, start.device, memory.terrain().staging, traced);
}

base::Error FramePainter::start_elements(const FramePlanner& planner, DisplayMemory& memory) {
    return elements_.start(gl_, device_->budget, memory.elements(), planner.elements(), symbology_, planner.data_variant());
}

void FramePainter::seal() {
    gl_.seal();
    gl_.use_programs(nullptr);
}

void FramePainter::stop() {
    gl_.retire();
    symbology_.destroy(gl_);
    passes_.destroy(gl_);
    stereo_.destroy(gl_);
    fade_.destroy(gl_);
    saliency_.destroy(gl_);
    edges_.destroy(gl_);
    dimmer_.destroy(gl_);
    elements_.destroy(gl_);
    terrain_.destroy(gl_);
}

PainterAbilities FramePainter::abilities() const {
    PainterAbilities abilities;
    abilities.is_stereo = stereo_.is_started();
    abilities.fades = fade_.is_started();
    abilities.stereo_margin_px = stereo_.margin_px();
    if (!has_terrain_) return abilities;
    abilities.ground_side = terrain_.ground_side();
    abilities.reads_pages = terrain_.reads_pages();
    abilities.tracer = terrain_.tracer();
    return abilities;
}

draw::DrawnDesign FramePainter::drawn_design(const design::DesignSettings& design, bool has_focus) const {
    return draw::drawn_as(design, draw::ability_of(*device_), has_focus);
}

bool FramePainter::can_show(const design::DesignSettings& possible) const {
    const bool is_dimmable = dimmer_.is_started() || possible.effects.lighting == design::PanelLighting::day;
    if (!is_dimmable || !saliency_.can_show(possible.effects.saliency.view) || !elements_.can_show(possible)) return false;
    const design::DesignSettings weighted = design::weighted(possible);
    for (const design::DesignSettings* const design : {&weighted, &possible})
        for (const bool has_focus : {false, true}) {
            const draw::DrawnDesign drawn = drawn_design(*design, has_focus);
            if (!passes_.shows(drawn) || !terrain_.shows(drawn)) return false;
        }
    return true;
}

void FramePainter::begin(base::Surface& surface) {
    gl_.begin_frame();
    drawn_ = {};
    gl::bind_surface(gl_, surface);
}

void FramePainter::follow_look(const PlannedFrame& frame) {
    if (frame.look_key == look_key_) return;
    look_key_ = frame.look_key;
    const draw::DrawnDesign drawn = drawn_design(*frame.shown, frame.draws_foci);
    passes_.set_design(drawn);
    terrain_.set_design(gl_, drawn);
}

bool FramePainter::prepare(const PlannedFrame& frame) {
    follow_look(frame);
    if (has_terrain_ && frame.ground_key != ground_key_) {
        ground_key_ = frame.ground_key;
        drawn_.ground_data_is_missing = !terrain_.set_ground_data(gl_, frame.ground_slice);
    }
    const bool ready =
        frame.decisions.show_terrain &&
        terrain_.prepare(gl_, frame.picture.terrain, make_terrain_input(draw_context_of(frame, frame.picture.camera)));
    prepare_elements(frame.picture);
    return ready || !frame.decisions.show_terrain;
}

void FramePainter::prepare_elements(const PlannedPicture& picture) {
    if (elements_.is_started()) elements_.prepare(gl_, picture.data);
}

draw::TerrainDrawResult FramePainter::draw_scene(const PlannedFrame& frame, const PlannedPicture& picture,
                                                 const gl::DrawPlace& place, PictureLayer last, bool has_shadow_map) {
    const DrawContext context = draw_context_of(frame, picture.camera, last);
    return passes_.draw(gl_, place,
                        {context, frame.effects, terrain_, picture.terrain, elements_, picture.data, picture.casters, drawn_.work,
                         frame.terrain_has_void, has_shadow_map, frame.clutter.has_terrain});
}

draw::TerrainDrawResult FramePainter::draw_kept(const PlannedFrame& frame) {
    follow_look(frame);
    return draw_scene(frame, frame.picture, fade_.target());
}

draw::TerrainDrawResult FramePainter::draw_side(const PlannedFrame& frame, const PlannedPicture& picture, PictureLayer last,
                                                draw::EyeSide side) {
    return draw_scene(frame, picture, stereo_.target(), last, side == draw::EyeSide::right);
}

void FramePainter::put_side(const base::Surface& surface, design::StereoMode mode, draw::EyeSide side, std::int32_t shift_px) {
    stereo_.put(gl_, surface, mode, side, shift_px);
}

void FramePainter::draw_fade(const PlannedFrame& frame) {
    if (!frame.effects.runs(effects::Effect::cross_fade) || !fade_.is_started()) return;
    const WorkScope work(gl_, drawn_.work[effects::Effect::cross_fade]);
    fade_.draw(gl_, frame.earlier_share);
}

void FramePainter::draw_symbology(const PlannedFrame& frame, const base::Surface& surface) {
    const bool has_halves = stereo_.is_started() && frame.shown->effects.stereo.mode == design::StereoMode::side_by_side;
    for (const draw::EyeSide side : draw::kEyeSides) {
        if (has_halves) draw::StereoPass::begin_half(gl_, surface, side);
        symbology_.draw(gl_, width_px_, height_px_);
        if (!has_halves) return;
    }
    draw::StereoPass::end_halves(gl_, surface);
}

effects::ClutterMap FramePainter::measure_clutter(const base::Surface& surface) {
    const WorkScope scope(gl_, drawn_.work[effects::Effect::clutter]);
    return edges_.measure(gl_, surface);
}

void FramePainter::draw_measures(const PlannedFrame& frame, const base::Surface& surface) {
    draw_edges(frame, surface);
    draw_saliency(frame, surface);
}

void FramePainter::draw_edges(const PlannedFrame& frame, const base::Surface& surface) {
    const design::ClutterView view = frame.shown->effects.clutter;
    if (view == design::ClutterView::none || !frame.effects.runs(effects::Effect::clutter)) return;
    const WorkScope scope(gl_, drawn_.work[effects::Effect::clutter], 2);
    static_cast<void>(edges_.measure(gl_, surface));
    edges_.show(gl_, view == design::ClutterView::edges ? draw::EdgeView::edges : draw::EdgeView::regions);
}

void FramePainter::draw_saliency(const PlannedFrame& frame, const base::Surface& surface) {
    if (!frame.saliency.is_shown) return;
    const bool is_measured = frame.saliency.is_measured;
    const WorkScope scope(gl_, drawn_.work[effects::Effect::saliency], is_measured ? 2 : 1);
    if (is_measured) saliency_.measure(gl_, surface, frame.shown->effects.saliency.scale);
    saliency_.show(gl_, frame.shown->effects.saliency.view);
}

void FramePainter::dim(const PlannedFrame& frame) {
    if (!frame.effects.runs(effects::Effect::panel_lighting) || !dimmer_.is_started()) return;
    const WorkScope work(gl_, drawn_.work[effects::Effect::panel_lighting]);
    dimmer_.draw(gl_, frame.panel.white);
}

/// Data on the ground go by the strength that their program draws them with.
void FramePainter::bare_ground(const PlannedFrame& frame, PictureLayer last) {
    if (!has_terrain_ || last >= PictureLayer::uncertainty) return;
    design::DesignSettings bare = *frame.shown;
    bare.data.ground.uncertainty.strength = bare.data.ground.overlay.strength = 0;
    if (last < PictureLayer::data) bare.data.ground.opacity = 0;
    terrain_.set_design(gl_, drawn_design(bare, frame.draws_foci));
}

void FramePainter::restore_ground(const PlannedFrame& frame) {
    if (has_terrain_) terrain_.set_design(gl_, drawn_design(*frame.shown, frame.draws_foci));
}

DrawnFrame FramePainter::drawn(const draw::TerrainDrawResult& terrain) {
    drawn_.terrain = terrain;
    drawn_.uploaded_bytes = gl_.frame().uploaded_bytes;
    return drawn_;
}

}  // namespace tedavis::display
