// What of the display plans the data elements and the foci, and what lies before a frame.
#include "render_core/display/display.hpp"
#include "render_core/display/symbology_plan.hpp"
#include "render_core/display/terrain_ground.hpp"

namespace tedavis::display {

void Display::set_elements() {
    const scene::Scene* const scene = data_.has_scene() ? &data_.scene() : nullptr;
    elements_.set(scene, settings_.design.data.elements, settings_.design.labels, shown_);
}

/// Of other designs, or another scene.
void Display::note_epochs() {
    has_epochs_ = terrain_.is_started();  // it may be ahead
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        const design::DesignSettings& design = design_at(place);
        const bool has_labels =
            elements_.is_started() && data_.has_scene() && ElementLabels::is_any(data_.scene(), design.data.elements);
        has_epochs_ = has_epochs_ || has_labels || design.priority.is_stated;
    }
}

/// Where they are, whatever is shown of them.
void Display::plan_foci() {
    foci_ = {};
    if (settings_.design.foci.empty() || !terrain_.is_started()) return;
    const design::PrioritySettings& priority = settings_.design.priority;
    TerrainGround ground(terrain_, eye_.view);
    const double own_height_m = aircraft_msl_m_ + undulation_m(state_.own_ship.position);
    foci_ =
        display::plan_foci(settings_.design.foci, {state_.own_ship, own_height_m, data_.has_scene() ? &data_.scene() : nullptr,
                                                   record_.flight_time, ground, priority.is_stated ? raised_.hazard() : nullptr});
}

ElementFrame Display::element_frame(scene::Ground& ground, const terrain::View& view, const flight::FlownWay* way) const {
    return {ground,
            view,
            settings_.design.terrain.unknown,
            record_.flight_time,
            {way, &state_, record_.time},
            frame_budget_.detail_factor(),
            foci_.foci.regions.empty() ? nullptr : &foci_.foci,
            crowding_.regions.is_whole() ? nullptr : &crowding_};
}

/// Symbology first, then the signs in the room that it leaves.
void Display::plan_elements(const flight::FlownWay* way) {
    TerrainGround ground(terrain_, seen_);
    if (shows_elements())
        elements_.plan(element_frame(ground, seen_, way));
    else
        elements_.rest();
    conditions_.data_are_out_of_date =
        data_plan_.ground == GroundDataState::out_of_date || any_is_out_of_date(elements_.reports());
    if (conditions_.data_are_out_of_date) decide_again();
    put_symbology();
    way_ = way;
    // Of a picture for each eye they are planned once more with the eye.
    if (shows_elements()) plan_signs(eye_, {});
    note_labels();
    note_stale_data();
    if (!foci_.foci.regions.empty()) note_foci(foci_, elements_, element_frame(ground, seen_, way), record_);
}

void Display::note_labels() {
    const LabelCounts& labels = elements_.label_counts();
    record_.labels = {labels.placed, labels.suppressed, labels.changed, labels.lowered};
}

void Display::plan_signs(const Eye& eye, SignFrame signs) {
    TerrainGround ground(terrain_, eye.view);
    terrain::DrawnSight sight = terrain_.sight(eye.view);
    signs.text_px = text_px(context(), settings_.width_px, settings_.height_px);
    signs.sight = &sight;
    signs.is_metric = settings_.design.symbology.legend_unit == design::HeightUnit::metres;
    signs.symbology = free_view_active_ ? nullptr : &symbology_;
    elements_.plan_signs(element_frame(ground, eye.view, way_), signs);
}

/// Nothing of a picture without terrain.
void Display::decide_labels() {
    if (!elements_.is_started()) return;
    if (!decisions_.show_terrain) return elements_.labels().skip(record_.time);
    TerrainGround ground(terrain_, eye_.view);
    elements_.decide_labels(element_frame(ground, eye_.view, nullptr),
                            text_px(context(), settings_.width_px, settings_.height_px));
}

void Display::approach(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                       const flight::FlownWay* way) {
    const std::uint64_t frame = frame_;
    update(state, phase, now, way);
    frame_ = frame;
}

void Display::settle(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now) {
    constexpr int kMostTimes = 64;
    forget_turns();
    for (int n = 0; n < kMostTimes; ++n) {
        approach(state, phase, now);
        if (record_.terrain.pending == 0) return;
    }
}

void Display::approach_epoch(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now) {
    const std::uint64_t frame = frame_;
    const policy::DisplayConditions conditions = conditions_;
    const policy::DisplayDecisions decisions = decisions_;
    const ViewTransition transition = transition_;
    const design::AspectWeights weights = weights_;
    const bool shows_alert = shows_alert_;
    const std::size_t shown = shown_;
    shown_ = phases_.place_of(phase.presented);
    if (shown_ != shown) take_weights();
    transition_ = ViewTransition();
    begin_update(state, phase, now);
    const bool is_as_shown = shown_ == shown && weights_ == weights && shows_alert_ == shows_alert;
    shown_ = shown;
    weights_ = weights;
    shows_alert_ = shows_alert;
    if (!is_as_shown) take_weights();
    has_new_look_ = false;
    transition_ = transition;
    decisions_ = decisions;
    conditions_ = conditions;
    frame_ = frame;
}

EpochMemory Display::epoch() const {
    EpochMemory memory;
    if (elements_.is_started()) elements_.labels().keep(memory.labels);
    memory.weights = raised_;
    return memory;
}

void Display::restore(const EpochMemory& memory) {
    if (elements_.is_started()) elements_.labels().restore(memory.labels);
    raised_ = memory.weights;
}

}  // namespace tedavis::display
