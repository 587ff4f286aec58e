// Plans the data of a frame: elements, labels, and what is reduced where the picture is too cluttered.
#include "render_core/display/planner/frame_notes.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/planner/symbology_plan.hpp"
#include "render_core/display/planner/terrain_ground.hpp"

namespace tedavis::display {
namespace {

/// Glyphs of fields and points, not those of the air round the own ship; and names.
bool may_declutter(const ElementReport& report, const policy::Declutter& declutter) {
    if (report.state != ElementState::shown || report.layer == nullptr) return false;
    const bool has_glyphs = is_glyph_technique(report.element->technique) && report.slot < GlyphElements::kSlots;
    return (has_glyphs || has_labels(*report.element, *report.layer)) &&
           declutter.regions_of(*report.element, report.layer->entry->role, draw::is_protected(*report.layer)) != nullptr;
}

}  // namespace

void FramePlanner::set_elements(std::size_t shown) {
    const scene::Scene* const scene = data_.has_scene() ? &data_.scene() : nullptr;
    elements_.set(scene, look_.data.elements, look_.labels, shown);
}

bool FramePlanner::accepts(const scene::Scene& scene) const {
    const bool is_unexpected = terrain_.is_started() && !data_.has_scene() && !settings_.expects_scene;
    return !is_unexpected && data_.is_newer(scene);
}

bool FramePlanner::take_scene(const scene::Scene& scene, PlannerMemory& memory) {
    if (!data_.take(scene)) return false;
    memory.boost.forget_obstacles();
    find_intervals();
    memory.clutter.forget();
    if (!elements_.is_started()) return true;
    set_elements(memory.shown);
    memory.labels.forget();
    return true;
}

/// Of other designs, or another scene.
void FramePlanner::find_intervals() {
    has_intervals_ = terrain_.is_started();  // it may be ahead
    for (std::size_t place = 0; place < design_count(); ++place) {
        const design::DesignSettings& design = design_at(place);
        const bool has_labels =
            elements_.is_started() && data_.has_scene() && ElementLabels::is_any(data_.scene(), design.data.elements);
        has_intervals_ = has_intervals_ || has_labels || design.priority.is_stated;
    }
}

ElementFrame FramePlanner::element_frame(scene::Ground& ground, const terrain::View& view) const {
    return {ground,
            view,
            look_.data.missing,
            frame_->flight_time,
            {frame_->trail, &frame_->state, frame_->time},
            memory_->budget.detail_factor(),
            frame_->foci_plan.foci.regions.empty() ? nullptr : &frame_->foci_plan.foci,
            frame_->declutter.regions.is_whole() ? nullptr : &frame_->declutter,
            frame_->alerts.obstacle == policy::TerrainAhead::none || frame_->decisions.unusual_attitude
                ? nullptr
                : &frame_->alerts.obstacles,
            look_.symbology.units};
}

/// Plans the symbology first, then the signs in the room that it leaves.
void FramePlanner::plan_elements() {
    TerrainGround ground(terrain_, frame_->seen);
    if (shows_elements())
        elements_.plan(element_frame(ground, frame_->seen));
    else
        elements_.rest();
    frame_->conditions.data_are_out_of_date =
        frame_->data.ground == GroundDataState::out_of_date || any_is_out_of_date(elements_.reports());
    state_stale_data();
    frame_->conditions.data_are_stale = !frame_->stale.empty();
    if (frame_->conditions.data_are_out_of_date || frame_->conditions.data_are_stale) decide_again();
    put_symbology();
    // Of a picture for each eye they are planned once more with the eye.
    if (shows_elements()) plan_signs(frame_->picture.camera, {});
    state_labels();
    if (!frame_->foci_plan.foci.regions.empty())
        record_foci(frame_->foci_plan, elements_, element_frame(ground, frame_->seen), *frame_);
}

void FramePlanner::state_labels() {
    const LabelCounts& labels = elements_.label_counts();
    frame_->labels = {labels.placed, labels.suppressed, labels.changed, labels.decluttered};
}

void FramePlanner::plan_signs(const Camera& camera, SignFrame signs) {
    TerrainGround ground(terrain_, camera.view);
    terrain::LineOfSight sight = terrain_.sight(camera.view);
    signs.text_px = text_px(context_of(*frame_, camera), settings_.width_px, settings_.height_px);
    signs.sight = &sight;
    signs.symbology = free_view_active_ ? nullptr : &symbology_;
    elements_.plan_signs(element_frame(ground, camera.view), signs);
}

/// Decides nothing for a picture without terrain.
void FramePlanner::decide_labels() {
    if (!elements_.is_started()) return;
    if (!frame_->decisions.show_terrain) return elements_.labels().skip(frame_->time);
    TerrainGround ground(terrain_, frame_->picture.camera.view);
    elements_.decide_labels(element_frame(ground, frame_->picture.camera.view),
                            text_px(context_of(*frame_, frame_->picture.camera), settings_.width_px, settings_.height_px));
}

/// Uses the quality level of the frame before, so the notice follows the view at most a frame late.
bool FramePlanner::shows_measure() const {
    using effects::Effect;
    const design::ViewEffects& asked = look_.effects;
    return (asked.saliency.view != design::SaliencyView::none && !memory_->budget.gives_up(Effect::saliency)) ||
           (asked.clutter != design::ClutterView::none && !memory_->budget.gives_up(Effect::clutter));
}

void FramePlanner::plan_declutter() {
    memory_->clutter.follow(frame_->time, frame_->picture.camera.view);
    const design::PrioritySettings& priority = look_.priority;
    frame_->declutter = policy::declutter_of(memory_->clutter.regions(frame_->time, memory_->shown), priority, memory_->weights);
}

bool FramePlanner::has_declutterable_data() const {
    const policy::Declutter declutter = policy::declutter_of(effects::least_detail(), look_.priority, memory_->weights);
    for (const ElementReport& report : elements_.reports())
        if (may_declutter(report, declutter)) return true;
    return false;
}

/// Plans glyphs and signs of the frame with the detail that frame_->declutter keeps.
void FramePlanner::plan_detail_again(bool is_shown) {
    if (!shows_elements()) return;
    TerrainGround ground(terrain_, frame_->seen);
    elements_.plan_detail(element_frame(ground, frame_->seen));
    SignFrame signs;
    signs.is_planned_again = !is_shown;
    plan_signs(frame_->picture.camera, signs);
    if (!is_shown) return;
    const std::uint32_t changed = frame_->labels.changed;
    state_labels();
    frame_->labels.changed += changed;
}

/// Plans the picture that the clutter budget requests to measure. The first one is the frame itself where it has all its detail
/// and no other design's picture fades out in it.
void FramePlanner::plan_probe() {
    using Step = DeclutterControl::Step;
    PlannedClutter& clutter = frame_->clutter;
    const Step step = memory_->clutter.step();
    if (step == Step::none) return;
    if (clutter.probe == Probe::none) clutter.before_probes = frame_->declutter;
    const bool has_all = frame_->declutter.regions.is_whole() && !frame_->keeps_scene && frame_->earlier_share <= 0;
    clutter.probe = step == Step::whole && has_all ? Probe::shown : Probe::hidden;
    if (clutter.probe == Probe::shown) return;
    frame_->declutter = policy::declutter_of(memory_->clutter.step_regions(), look_.priority, memory_->weights);
    plan_detail_again(false);
    set_camera_data();
}

/// Plans the frame that is shown, with the measurements of its probes. A probe that is shown is not planned again.
void FramePlanner::plan_measured() {
    PlannedClutter& clutter = frame_->clutter;
    const bool is_planned = clutter.probe == Probe::shown;
    clutter.probe = Probe::none;
    if (is_planned) return;
    plan_declutter();
    plan_detail_again(clutter.before_probes.regions.factor != frame_->declutter.regions.factor);
    set_camera_data();
    if (elements_.is_started()) elements_.labels().keep(memory_->labels);
}

PlannedPicture FramePlanner::plan_side(const StereoCameras& pair, draw::EyeSide side, PlannerMemory& memory,
                                       PlannedFrame& frame) {
    memory_ = &memory;
    frame_ = &frame;
    PlannedPicture picture;
    picture.camera = camera_of(frame.picture.camera, pair, side, painter_.stereo_margin_px);
    if (shows_elements()) {
        const std::uint32_t margin_px = painter_.stereo_margin_px;
        plan_signs(picture.camera, {{}, {}, {}, 2 * margin_px, draw::screen_begins_px(margin_px, side, pair.shift_px), true});
        elements_.set_camera(picture.camera.view.eye);
    }
    picture.terrain = terrain_.seen_from(picture.camera.view);
    picture.data = elements_.planned();
    picture.casters = elements_.casters(look_.effects.shadows.casters);
    return picture;
}

void FramePlanner::conclude(PlannerMemory& memory, PlannedFrame& frame) {
    frame.clutter.has_terrain = false;
    if (frame.saliency.is_measured) memory.saliency.take();
    if (look_.priority.held_clutter() >= 1) return;
    const DeclutterControl::Measured measured = memory.clutter.measured(frame.time, memory.shown);
    frame.clutter.measured = measured.clutter;
    frame.clutter.reached = measured.reached;
    for (const ElementReport& report : elements_.reports())
        if (may_declutter(report, frame.declutter)) frame.clutter.roles |= 1u << static_cast<unsigned>(report.layer->entry->role);
}

}  // namespace tedavis::display
