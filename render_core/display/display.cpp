#include "render_core/display/display.hpp"

#include "render_core/design/weighted_design.hpp"
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
    if (base::Error error = planner_.take_designs(settings, memory_)) return error;
    base::BudgetTable& budget = planner_.settings().device.budget;
    if (base::Error error = arenas_.cut(budget, memory)) return error;
    if (base::Error error = painter_.open(surface, settings.device, settings.programs)) return error;
    if (base::Error error = start_all(terrain, scene)) return error;
    painter_.seal();
    arenas_.note_use(budget);
    frame_.shown = &planner_.look();  // who draws before the first plan sees no terrain
    frame_.look_key = planner_.look_key();
    return {};
}

/// Designs with foci are drawn as they are where there is none, too.
base::Error Display::start_all(const TerrainInput& terrain, base::ByteSource* scene) {
    DisplaySettings& settings = planner_.settings();
    const WeightedDesigns weighted(planner_);
    base::FixedVector<draw::DrawnDesign, 2 * kMaxDrawn> designs;
    for (const bool has_focus : {false, true})
        for (const design::DesignSettings* const design : weighted.all) {
            const draw::DrawnDesign drawn = draw::drawn_as(*design, settings.device.capability.depth24_targets, has_focus);
            if (drawn.has_focus == has_focus) static_cast<void>(designs.try_push_back(drawn));
        }
    planner_.start_memory(designs, memory_);
    const PainterStart start{settings.device,    designs,
                             memory_.clutter,    settings.width_px,
                             settings.height_px, planner_.stereo_margin_px(planner_.design_at(0))};
    if (base::Error error = planner_.start_symbology(arenas_.symbology())) return error;
    if (base::Error error = painter_.start(start, planner_)) return error;
    if (base::Error error = planner_.start_terrain(terrain, designs, arenas_.terrain())) return error;
    if (base::Error error = painter_.start_terrain(start, planner_, arenas_, terrain.workers)) return error;
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

bool Display::asks_for_rays(const DisplaySettings& settings) {
    bool asks = settings.design.terrain.renderer == design::TerrainRenderer::trace;
    const std::size_t count = settings.phases != nullptr ? settings.phases->size() : 0;
    for (std::size_t place = 1; place <= count; ++place)
        asks = asks || settings.phases->at(place).terrain.renderer == design::TerrainRenderer::trace;
    return asks;
}

bool Display::can_show(const design::DesignSettings& possible) const {
    return planner_.stereo_margin_px(possible) == painter_.abilities().stereo_margin_px && memory_.clutter.can_show(possible) &&
           painter_.can_show(possible);
}

bool Display::set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases) {
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    for (std::size_t place = 0; place <= count; ++place)
        if (!can_show(effects::possible_design(place == 0 ? design : phases->at(place), planner_.settings().device)))
            return false;
    keep_scene();
    planner_.set_designs(design, phases, memory_);
    return true;
}

/// All designs are judged before any is changed.
bool Display::set_foci(const design::FocusList& chosen) {
    for (std::size_t place = 0; place < planner_.design_count(); ++place) {
        design::DesignSettings design;
        if (!planner_.with_foci(chosen, place, design) || !can_show(design)) return false;
    }
    planner_.set_foci(chosen, memory_);
    return true;
}

bool Display::take_scene(const scene::Scene& scene) {
    if (!planner_.accepts(scene)) return false;
    keep_scene();
    return planner_.take_scene(scene, memory_);
}

/// What is planned, once more, before it is replaced.
void Display::keep_scene() {
    if (!planner_.fades() || memory_.frames == 0) return;
    painter_.draw_kept(frame_);
    planner_.keep_scene(frame_, memory_);
}

void Display::update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                     const flight::FlightTrail* trail) {
    planner_.plan({state, phase, now, trail}, memory_, frame_);
    record_ = {};
    static_cast<FrameStatement&>(record_) = frame_;
}

void Display::preroll(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                      const flight::FlightTrail* trail) {
    const std::uint64_t frames = memory_.frames;
    update(state, phase, now, trail);
    memory_.frames = frames;
}

void Display::preroll_interval(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now) {
    planner_.decide_interval({state, phase, now, nullptr}, memory_, scratch_);
}

void Display::settle(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now) {
    constexpr int kMaxTimes = 64;
    cut_to_design();
    for (int n = 0; n < kMaxTimes; ++n) {
        preroll(state, phase, now);
        if (frame_.terrain.pending == 0) return;
    }
}

IntervalMemory Display::interval_memory() const { return {memory_.labels, memory_.boost}; }

void Display::restore(const IntervalMemory& memory) {
    const LabelHistory now = memory_.labels;
    memory_.labels = memory.labels;
    memory_.labels.labels.gone = 0;
    memory_.labels.is_anew = false;
    memory_.labels.last_now = now.last_now;
    memory_.labels.last_eye = now.last_eye;
    memory_.labels.last_forward = now.last_forward;
    memory_.boost = memory.weights;
}

void Display::draw(base::Surface& surface) {
    painter_.begin(surface);
    if (!painter_.prepare(frame_)) planner_.plan_without_terrain(memory_, frame_);
    const draw::TerrainDrawResult terrain = paint_measured(surface);
    planner_.conclude(memory_, frame_);
    record_ = record_of(frame_, painter_.drawn(terrain), planner_.elements().reports(), budget());
}

/// Data on the ground go by the strength that their program draws them with.
void Display::draw_up_to(base::Surface& surface, PictureLayer last) {
    const EffectWorkTable work = painter_.work();
    painter_.bare_ground(frame_, last);
    painter_.begin(surface);
    static_cast<void>(paint(surface, last, false));
    painter_.restore_ground(frame_);
    painter_.work() = work;
}

draw::TerrainDrawResult Display::paint(base::Surface& surface, PictureLayer last, bool is_unseen) {
    const draw::TerrainDrawResult drawn = draw_scene(surface, last, is_unseen);
    if (!is_unseen) painter_.draw_fade(frame_);
    const bool is_whole = last == PictureLayer::symbology;
    if (!frame_.is_free_view && is_whole) painter_.draw_symbology(frame_, surface);
    if (is_whole) measure(surface, is_unseen);
    if (is_unseen) return drawn;
    if (is_whole && memory_.saliency.runs()) {
        painter_.draw_saliency(frame_, surface, memory_.saliency.measures());
        if (memory_.saliency.measures()) memory_.saliency.take();
    }
    painter_.dim(frame_);
    return drawn;
}

draw::TerrainDrawResult Display::draw_scene(base::Surface& surface, PictureLayer last, bool is_unseen) {
    if (painter_.abilities().is_stereo) return draw_sides(surface, last);
    if (frame_.keeps_scene && !is_unseen) {
        const draw::TerrainDrawResult drawn = painter_.draw_kept(frame_);
        gl::bind_surface(painter_.gl(), surface);
        return drawn;  // what was kept covers the surface
    }
    return painter_.draw_scene(frame_, frame_.camera, surface, last);
}

draw::TerrainDrawResult Display::draw_side(const EyePair& pair, draw::EyeSide side, PictureLayer last) {
    const PlannedCamera camera = planner_.plan_side(pair, side, memory_, frame_);
    painter_.prepare_elements(camera);
    return painter_.draw_side(frame_, camera, last, side);
}

/// One picture is for both where they cannot be told apart; in its own colours then.
draw::TerrainDrawResult Display::draw_sides(base::Surface& surface, PictureLayer last) {
    using draw::EyeSide;
    const design::StereoMode mode = frame_.shown->effects.stereo.mode;
    if (!frame_.effects.runs(Effect::stereo)) {
        const draw::TerrainDrawResult drawn = draw_side({}, EyeSide::left, last);
        const bool has_halves = mode == design::StereoMode::side_by_side;
        painter_.put_side(surface, has_halves ? mode : design::StereoMode::none, EyeSide::left, 0);
        if (has_halves) painter_.put_side(surface, mode, EyeSide::right, 0);
        return drawn;
    }
    const draw::TerrainDrawResult drawn = draw_side(frame_.eyes, EyeSide::left, last);
    painter_.put_side(surface, mode, EyeSide::left, frame_.eyes.shift_px);
    const WorkScope work(painter_.gl(), painter_.work()[Effect::stereo]);
    static_cast<void>(draw_side(frame_.eyes, EyeSide::right, last));
    painter_.put_side(surface, mode, EyeSide::right, frame_.eyes.shift_px);
    return drawn;
}

/// Where the picture that is shown has all its detail it is the one that is measured.
draw::TerrainDrawResult Display::paint_measured(base::Surface& surface) {
    constexpr PictureLayer kWhole = PictureLayer::symbology;
    if (memory_.clutter.step() == ClutterControl::Step::none) return paint(surface, kWhole, false);
    const bool is_whole = frame_.declutter.regions.is_whole() && !frame_.keeps_scene && frame_.earlier_share <= 0;
    if (is_whole) {
        const EffectWorkTable work = painter_.work();
        const draw::TerrainDrawResult drawn = paint(surface, kWhole, false);
        if (memory_.clutter.step() == ClutterControl::Step::none) return drawn;
        const EffectWork measured = painter_.work()[Effect::clutter];
        painter_.work() = work;
        painter_.work()[Effect::clutter] = measured;
    }
    measure_unseen(surface);
    planner_.plan_measured(frame_.declutter, memory_, frame_);
    painter_.prepare_elements(frame_.camera);
    return paint(surface, kWhole, false);
}

/// What is on the surface, where it is what is to be measured; else its edges, where the design shows them.
void Display::measure(base::Surface& surface, bool is_unseen) {
    const design::ClutterView view = frame_.shown->effects.clutter;
    if (memory_.clutter.step() != ClutterControl::Step::none) memory_.clutter.take(painter_.measure_clutter(surface));
    if (is_unseen || view == design::ClutterView::none || !frame_.effects.runs(Effect::clutter)) return;
    painter_.show_clutter(surface, view);
}

/// Of the design that is shown alone, whatever fades. The surface is left with a picture that is nobody's.
void Display::measure_unseen(base::Surface& surface) {
    const policy::Declutter shown = frame_.declutter;
    const EffectWorkTable work = painter_.work();
    EffectWork unseen = painter_.work()[Effect::clutter];
    while (memory_.clutter.step() != ClutterControl::Step::none) {
        const WorkScope scope(painter_.gl(), unseen, 2);
        planner_.plan_probe(memory_, frame_);
        painter_.prepare_elements(frame_.camera);
        static_cast<void>(paint(surface, PictureLayer::symbology, true));
    }
    frame_.declutter = shown;
    painter_.work() = work;
    painter_.work()[Effect::clutter] = unseen;
}

}  // namespace tedavis::display
