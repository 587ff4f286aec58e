// What of the display holds a budget of clutter: what gives way in a frame, and pictures that are drawn to be measured.
#include "render_core/display/display.hpp"
#include "render_core/display/terrain_ground.hpp"

namespace tedavis::display {
namespace {

/// Glyphs of fields and points, not those of the air round the own ship; and names.
bool gives_way(const ElementReport& report, const policy::Declutter& crowding) {
    if (report.state != ElementState::shown || report.layer == nullptr) return false;
    const bool has_glyphs = is_glyph_technique(report.element->technique) && report.slot < GlyphElements::kSlots;
    return (has_glyphs || has_labels(*report.element, *report.layer)) &&
           crowding.regions_of(*report.element, report.layer->entry->role, draw::is_protected(*report.layer)) != nullptr;
}

}  // namespace

/// By the rung of the frame before: the notice comes and goes with the view, a frame late at most.
bool Display::shows_measure() const {
    using effects::Effect;
    const design::ViewEffects& asked = settings_.design.effects;
    return (asked.saliency.view != design::SaliencyView::none && !frame_budget_.gives_up(Effect::saliency)) ||
           (asked.clutter != design::ClutterView::none && !frame_budget_.gives_up(Effect::clutter));
}

void Display::plan_crowding() {
    clutter_.follow(record_.time, eye_.view);
    const design::PrioritySettings& priority = settings_.design.priority;
    crowding_ = policy::declutter_of(clutter_.regions(record_.time, shown_), priority, weights_);
}

bool Display::has_what_gives_way() const {
    const policy::Declutter crowding = policy::declutter_of(effects::least_detail(), settings_.design.priority, weights_);
    for (const ElementReport& report : elements_.reports())
        if (gives_way(report, crowding)) return true;
    return false;
}

/// Glyphs and signs of the planned frame, as far as crowding_ leaves them.
void Display::plan_detail_again(bool is_shown) {
    if (!shows_elements()) return;
    TerrainGround ground(terrain_, seen_);
    elements_.plan_detail(element_frame(ground, seen_, way_));
    SignFrame signs;
    signs.is_planned_again = !is_shown;
    plan_signs(eye_, signs);
    prepare_elements();
    if (!is_shown) return;
    const std::uint32_t changed = record_.labels.changed;
    note_labels();
    record_.labels.changed += changed;
}

/// Where the picture that is shown has all its detail it is the one that is measured.
draw::TerrainDrawResult Display::paint_measured(base::Surface& surface) {
    using effects::Effect;
    if (clutter_.step() == ClutterControl::Step::none) return paint(surface);
    const bool is_whole = crowding_.regions.is_whole() && turn_ != Turn::keeps && fade_share_ <= 0;
    if (is_whole) {
        const EffectWorkTable work = work_;
        const draw::TerrainDrawResult drawn = paint(surface);
        if (clutter_.step() == ClutterControl::Step::none) return drawn;
        const EffectWork measured = work_[Effect::clutter];
        work_ = work;
        work_[Effect::clutter] = measured;
    }
    measure_unseen(surface);
    show_measured();
    return paint(surface);
}

/// With nothing before it the frame goes by what it has just measured.
void Display::show_measured() {
    const policy::Declutter planned = crowding_;
    plan_crowding();
    plan_detail_again(planned.regions.factor != crowding_.regions.factor);
}

/// What is on the surface, where it is what is to be measured; else its edges, where the design shows them.
void Display::measure(base::Surface& surface) {
    const design::ClutterView view = settings_.design.effects.clutter;
    EffectWork& work = work_[effects::Effect::clutter];
    if (clutter_.step() != ClutterControl::Step::none) {
        const WorkScope scope(gl_, work);
        clutter_.measure(gl_, surface);
    }
    if (is_unseen_ || view == design::ClutterView::none || !plan_.runs(effects::Effect::clutter)) return;
    const WorkScope scope(gl_, work, 2);
    clutter_.show(gl_, surface, view);
}

/// Of the design that is shown alone, whatever fades. The surface is left with a picture that is nobody's.
void Display::measure_unseen(base::Surface& surface) {
    const policy::Declutter shown = crowding_;
    const EffectWorkTable work = work_;
    EffectWork unseen = work_[effects::Effect::clutter];
    is_unseen_ = true;
    while (clutter_.step() != ClutterControl::Step::none) {
        crowding_ = policy::declutter_of(clutter_.step_regions(), settings_.design.priority, weights_);
        const WorkScope scope(gl_, unseen, 2);
        plan_detail_again(false);
        static_cast<void>(paint(surface));
    }
    is_unseen_ = false;
    crowding_ = shown;
    work_ = work;
    work_[effects::Effect::clutter] = unseen;
}

void Display::note_clutter() {
    ClutterRecord& record = record_.clutter;
    record.budget = settings_.design.priority.held_clutter();
    if (record.budget >= 1) return;
    const ClutterControl::Measured measured = clutter_.measured(record_.time, shown_);
    record.measured = measured.clutter;
    record.reached = measured.reached;
    record.left = crowding_.regions;
    for (const ElementReport& report : elements_.reports())
        if (gives_way(report, crowding_)) record.roles |= 1u << static_cast<unsigned>(report.layer->entry->role);
}

}  // namespace tedavis::display
