#include "render_core/display/display.hpp"

#include "render_core/base/float_environment.hpp"
#include "render_core/design/weighted_design.hpp"
#include "render_core/display/planner/frame_notes.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::display {

using effects::Effect;

namespace {

constexpr std::size_t kMaxDrawn = 2 * (design::kMaxPhaseDesigns + 1);

/// Every design as its weights leave it, the one that is shown first; and as it was read, whose programs show it at any weights.
struct WeightedDesigns {
    explicit WeightedDesigns(const FramePlanner& planner) {
        for (std::size_t place = 0; place < planner.design_count(); ++place) {
            weighted[place] = design::weighted(planner.design_at(place));
            static_cast<void>(all.try_push_back(&weighted[place]));
        }
        for (std::size_t place = 0; place < planner.design_count(); ++place)
            if (planner.design_at(place).priority.is_stated) static_cast<void>(all.try_push_back(&planner.design_at(place)));
    }
    design::DesignSettings weighted[design::kMaxPhaseDesigns + 1];
    base::FixedVector<const design::DesignSettings*, kMaxDrawn> all;
};

}  // namespace

base::Error Display::start(const DisplaySettings& settings, base::Arena memory, base::Surface& surface,
                           const TerrainInput& terrain, base::ByteSource* scene) {
    if (base::Error error = arenas_.cut(settings.device.budget, memory)) return error;
    PlanPair shown;
    if (base::Error error = shown.start(arenas_.frames(), arenas_.memories())) return error;
    frame_ = shown.frame;
    memory_ = shown.memory;
    if (base::Error error = planner_.start_intervals(arenas_.frames(), arenas_.memories())) return error;
    if (base::Error error = planner_.take_designs(settings, *memory_)) return error;
    if (base::Error error = painter_.open(surface, settings.device, settings.programs)) return error;
    if (base::Error error = start_all(terrain, scene)) return error;
    painter_.seal();
    arenas_.record_use(planner_.settings().device.budget);
    frame_->shown = &planner_.look();  // who draws before the first plan sees no terrain
    frame_->look_key = planner_.look_key();
    return {};
}

/// Designs with foci are also drawn as in frames without a focus.
base::Error Display::start_all(const TerrainInput& terrain, base::ByteSource* scene) {
    DisplaySettings& settings = planner_.settings();
    const WeightedDesigns weighted(planner_);
    base::FixedVector<draw::DrawnDesign, 2 * kMaxDrawn> designs;
    for (const bool has_focus : {false, true})
        for (const design::DesignSettings* const design : weighted.all) {
            const draw::DrawnDesign drawn = draw::drawn_as(*design, draw::ability_of(settings.device), has_focus);
            if (drawn.has_focus == has_focus) static_cast<void>(designs.try_push_back(drawn));
        }
    planner_.start_memory(designs, *memory_);
    const PainterStart start{settings.device,    designs,
                             memory_->clutter,   settings.width_px,
                             settings.height_px, planner_.stereo_margin_px(planner_.design_at(0))};
    if (base::Error error = planner_.start_symbology(arenas_.symbology())) return error;
    if (base::Error error = painter_.start(start, planner_, arenas_)) return error;
    if (base::Error error = planner_.start_terrain(terrain, designs, arenas_.terrain())) return error;
    if (base::Error error = painter_.start_terrain(start, planner_.terrain(), arenas_, terrain.workers)) return error;
    const PainterAbilities painter = painter_.abilities();
    if (base::Error error = planner_.start_scene(scene, arenas_.scene(), painter.ground_side)) return error;
    if (planner_.has_data_to_show()) {
        const bool has_instances = draw::GlyphDrawer::has_instances(painter_.gl());
        if (base::Error error = planner_.start_elements(has_instances, arenas_.elements())) return error;
        if (base::Error error = painter_.start_elements(planner_, arenas_)) return error;
    }
    planner_.follow_painter(painter, designs);
    return {};
}

void Display::stop() { painter_.stop(); }

bool Display::can_show(const design::DesignSettings& possible) const {
    return planner_.stereo_margin_px(possible) == painter_.abilities().stereo_margin_px && memory_->clutter.can_show(possible) &&
           painter_.can_show(possible);
}

bool Display::set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases) {
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    for (std::size_t place = 0; place <= count; ++place)
        if (!can_show(effects::possible_design(place == 0 ? design : phases->at(place), planner_.settings().device)))
            return false;
    keep_scene();
    planner_.set_designs(design, phases, *memory_);
    return true;
}

bool Display::take_scene(const scene::Scene& scene) {
    if (!planner_.accepts(scene)) return false;
    keep_scene();
    return planner_.take_scene(scene, *memory_);
}

/// Draws the planned frame into the picture that is kept, before the design or the scene is replaced.
void Display::keep_scene() {
    if (!planner_.fades() || memory_->frames == 0) return;
    painter_.draw_kept(*frame_);
    planner_.keep_scene(*frame_, *memory_);
}

void Display::plan(const flight::FrameInput& input) {
    const bool was_changed = base::float_fault() != base::FloatFault::none;
    if (was_changed) base::set_float_environment();
    planner_.plan(input, *memory_, *frame_);
    if (was_changed) flag(policy::RecordFlag::arithmetic_changed, *frame_);
    record_ = {};
    static_cast<FrameStatement&>(record_) = *frame_;
}

void Display::draw(base::Surface& surface) {
    painter_.begin(surface);
    if (!painter_.prepare(*frame_)) planner_.plan_again({true, {}}, *memory_, *frame_);
    const draw::TerrainDrawResult terrain = paint_measured(surface);
    planner_.conclude(*memory_, *frame_);
    painter_.draw_measures(*frame_, surface);
    painter_.dim(*frame_);
    record_ = record_of(*frame_, painter_.drawn(terrain), planner_.elements().reports(), planner_.budget());
}

/// Data on the ground go by the strength that their program draws them with.
void Display::draw_up_to(base::Surface& surface, PictureLayer last) {
    const EffectWorkTable work = painter_.work();
    painter_.bare_ground(*frame_, last);
    painter_.begin(surface);
    static_cast<void>(paint(surface, last));
    if (last == PictureLayer::symbology) painter_.draw_measures(*frame_, surface);
    painter_.dim(*frame_);
    painter_.restore_ground(*frame_);
    painter_.work() = work;
}

/// Draws the frame's picture, after the pictures that are measured for it. Of pictures that are not shown only the work of
/// measuring is counted.
draw::TerrainDrawResult Display::paint_measured(base::Surface& surface) {
    const EffectWorkTable begun = painter_.work();
    draw::TerrainDrawResult drawn = paint_next(surface);
    while (frame_->clutter.probe != Probe::none) {
        const bool may_stay = frame_->clutter.probe == Probe::shown;
        planner_.plan_again({false, painter_.measure_clutter(surface)}, *memory_, *frame_);
        if (may_stay && frame_->clutter.probe == Probe::none) return drawn;
        const EffectWork measuring = painter_.work()[Effect::clutter];
        painter_.work() = begun;
        painter_.work()[Effect::clutter] = measuring;
        painter_.prepare_elements(frame_->picture);
        drawn = paint_next(surface);
    }
    return drawn;
}

draw::TerrainDrawResult Display::paint_next(base::Surface& surface) {
    if (frame_->clutter.probe != Probe::hidden) return paint(surface, PictureLayer::symbology);
    const WorkScope measuring(painter_.gl(), painter_.work()[Effect::clutter]);
    return paint(surface, PictureLayer::symbology);
}

/// Draws the planned picture without its measurements. In a picture that is not shown nothing fades.
draw::TerrainDrawResult Display::paint(base::Surface& surface, PictureLayer last) {
    const draw::TerrainDrawResult drawn = draw_scene(surface, last);
    if (frame_->clutter.probe != Probe::hidden) painter_.draw_fade(*frame_);
    if (!frame_->is_free_view && last == PictureLayer::symbology) painter_.draw_symbology(*frame_, surface);
    return drawn;
}

draw::TerrainDrawResult Display::draw_scene(base::Surface& surface, PictureLayer last) {
    if (painter_.abilities().is_stereo) return draw_sides(surface, last);
    if (frame_->keeps_scene && frame_->clutter.probe != Probe::hidden) {
        const draw::TerrainDrawResult drawn = painter_.draw_kept(*frame_);
        gl::bind_surface(painter_.gl(), surface);
        return drawn;  // what was kept covers the surface
    }
    return painter_.draw_scene(*frame_, frame_->picture, surface, last);
}

draw::TerrainDrawResult Display::draw_side(const StereoCameras& pair, draw::EyeSide side, PictureLayer last) {
    const PlannedPicture picture = planner_.plan_side(pair, side, *memory_, *frame_);
    painter_.prepare_elements(picture);
    return painter_.draw_side(*frame_, picture, last, side);
}

/// One picture is for both where they cannot be told apart; in its own colours then.
draw::TerrainDrawResult Display::draw_sides(base::Surface& surface, PictureLayer last) {
    using draw::EyeSide;
    const design::StereoMode mode = frame_->shown->effects.stereo.mode;
    if (!frame_->effects.runs(Effect::stereo)) {
        const draw::TerrainDrawResult drawn = draw_side({}, EyeSide::left, last);
        const bool has_halves = mode == design::StereoMode::side_by_side;
        painter_.put_side(surface, has_halves ? mode : design::StereoMode::none, EyeSide::left, 0);
        if (has_halves) painter_.put_side(surface, mode, EyeSide::right, 0);
        return drawn;
    }
    const draw::TerrainDrawResult drawn = draw_side(frame_->stereo_cameras, EyeSide::left, last);
    painter_.put_side(surface, mode, EyeSide::left, frame_->stereo_cameras.shift_px);
    const WorkScope work(painter_.gl(), painter_.work()[Effect::stereo]);
    static_cast<void>(draw_side(frame_->stereo_cameras, EyeSide::right, last));
    painter_.put_side(surface, mode, EyeSide::right, frame_->stereo_cameras.shift_px);
    return drawn;
}

}  // namespace tedavis::display
