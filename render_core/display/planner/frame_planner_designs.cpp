// The designs of a display: which phase has which, transitions between them, and the look of the one that is shown.
#include <glm/geometric.hpp>

#include "render_core/design/weighted_design.hpp"
#include "render_core/display/planner/frame_context.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/planner/stereo_cameras.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::display {
namespace {

constexpr double kMinTurnCosine = 0.9997;  // of a degree and a half

base::Error differing(const design::DesignSettings& one, const design::DesignSettings& other) {
    base::Error error = base::make_error("the designs '", one.name.view(), "' and '", other.name.view());
    error.message.append("' follow one another, so both need aerial perspective, and the same stereo, or neither; change one");
    return error;
}

}  // namespace

base::Error FramePlanner::take_designs(const DisplaySettings& settings, PlannerMemory& memory) {
    settings_ = settings;
    memory_ = &memory;
    const std::size_t count = settings.phases != nullptr ? settings.phases->size() : 0;
    if (settings.phases != nullptr) phases_ = *settings.phases;
    settings_.phases = nullptr;
    for (std::size_t place = 0; place <= count; ++place) {
        const design::DesignSettings& asked = place == 0 ? settings.design : settings.phases->at(place);
        if (const auto order = effects::replacement_order(asked.effects.instead); !order.ok())
            return base::make_error("the design's ", order.error().view());
        asked_of_[place] = effects::asked_effects(effects::design_on(settings_.device, asked));
        design::DesignSettings& kept = place == 0 ? design_ : phases_.at(place);
        kept = effects::possible_design(asked, settings_.device);
        if (kept.sky.air.is_shown != design_.sky.air.is_shown || stereo_margin_px(kept) != stereo_margin_px(design_))
            return differing(design_, kept);
    }
    show_design(0);
    return {};
}

/// Returns 0 where one picture is for both eyes.
std::uint32_t FramePlanner::stereo_margin_px(const design::DesignSettings& design) const {
    if (design.effects.stereo.mode == design::StereoMode::none) return 0;
    return eye_margin_px(design.view.horizontal_field_of_view_rad, settings_.width_px);
}

void FramePlanner::set_designs(const design::DesignSettings& design, const design::PhaseDesigns* phases, PlannerMemory& memory) {
    memory_ = &memory;
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    phases_ = phases != nullptr ? *phases : design::PhaseDesigns();
    for (std::size_t place = 0; place <= count; ++place) {
        const design::DesignSettings& asked = place == 0 ? design : phases->at(place);
        asked_of_[place] = effects::asked_effects(effects::design_on(settings_.device, asked));
        (place == 0 ? design_ : phases_.at(place)) = effects::possible_design(asked, settings_.device);
    }
    fit_palettes();
    memory.cut();
    show_design(0);
    memory.labels.forget();
    memory.boost.forget();
    memory.budget.forget_renderer();
    find_intervals();
}

bool FramePlanner::chooses_renderer() const {
    for (std::size_t place = 0; place < design_count(); ++place)
        if (design_at(place).terrain.renderer == design::TerrainRenderer::automatic) return true;
    return false;
}

/// Fits palettes to the heights of the terrain, as soon as these are known; see design::fitted_palette().
void FramePlanner::fit_palettes() {
    if (!terrain_.is_started()) return;
    const draw::HeightSpan span = height_span(terrain_.database().header());
    for (std::size_t place = 0; place < design_count(); ++place) {
        design::Palette& palette = (place == 0 ? design_ : phases_.at(place)).terrain.palette;
        palette = design::fitted_palette(palette, span.lowest_m, span.highest_m);
    }
}

void FramePlanner::show_design(std::size_t place) {
    memory_->shown = place;
    memory_->weights = design_at(place).priority.weights;
    take_look(asked_look());
}

/// The memory may be that of another frame than the last one.
void FramePlanner::sync_look() {
    const LookOf asked = asked_look();
    if (!(look_of_.shown == asked.shown && look_of_.weights == asked.weights)) take_look(asked);
    frame_->shown = &look_;
}

/// At other weights than the stated ones it has the programs of the design as it was read.
void FramePlanner::take_look(const LookOf& of) {
    const design::DesignSettings& stated = design_at(of.shown);
    look_ = stated;
    design::apply_priorities(of.weights, look_);
    if (!(of.weights == stated.priority.weights)) design::keep_programs(stated, look_);
    band_deviations_ = design::deviations_of_coverage(look_.widening.coverage);
    look_of_ = of;
    ++look_key_;
    if (elements_.is_started()) set_elements(of.shown);
}

/// A design that gives data or their uncertainty priority is shown only with a scene: without one the ground would lose detail
/// without any gain.
std::size_t FramePlanner::place_of(flight::FlightPhase phase) const {
    const std::size_t place = phases_.place_of(phase);
    return data_.has_scene() || design_at(place).priority.puts_terrain_first() ? place : 0;
}

/// While there is a warning the design changes at once, so that the warning is never shown in a picture that is half faded.
void FramePlanner::follow_phase() {
    if (memory_->transition.keeps) {
        memory_->transition.keeps = false;
        begin_fade(memory_->transition.at);
        show_design(memory_->transition.to);
    }
    const std::size_t place = place_of(frame_->phase.presented);
    const bool is_new = memory_->transition.is_first;
    memory_->transition.is_first = false;
    if (place == memory_->shown) return;
    if (is_new || !painter_.fades || memory_->had_warning) return show_design(place);
    memory_->transition.to = place;
    memory_->transition.at = frame_->time;
    memory_->transition.keeps = true;
}

/// Where no focus has a position the ground is drawn with the programs of a design without foci.
void FramePlanner::follow_foci() {
    const bool draws = frame_->foci_plan.foci.is_any() && frame_->decisions.show_terrain && !frame_->decisions.unusual_attitude;
    frame_->draws_foci = draws;
    if (draws != draws_foci_) ++look_key_;
    draws_foci_ = draws;
    if (terrain_look_key_ == look_key_) return;
    terrain_look_key_ = look_key_;
    terrain_.set_design(draw::drawn_as(look_, draw::ability_of(settings_.device), draws));
}

bool FramePlanner::has_warning() const {
    return frame_->decisions.unusual_attitude || frame_->decisions.terrain_ahead != policy::TerrainAhead::none ||
           frame_->decisions.obstacle_ahead != policy::TerrainAhead::none || !frame_->decisions.show_terrain ||
           frame_->conditions.terrain != policy::TerrainSource::ready;
}

void FramePlanner::keep_scene(const PlannedFrame& frame, PlannerMemory& memory) const {
    memory.transition.kept_view = frame.picture.camera.view;
    memory.transition.fades_next = true;
}

void FramePlanner::begin_fade(base::Time now) {
    memory_->transition.fade_lasts = true;
    memory_->transition.fade_began = now;
}

/// Returns the share of the kept picture in the planned frame.
double FramePlanner::next_fade_share() {
    if (memory_->transition.keeps) return 1;
    if (memory_->transition.fades_next) {
        memory_->transition.fades_next = false;
        begin_fade(frame_->time);
    }
    if (!memory_->transition.fade_lasts) return 0;
    const double share = 1 - (frame_->time - memory_->transition.fade_began).to_seconds() / look_.effects.fade_s;
    // A scene that stands still while the horizon turns would mislead.
    const bool has_turned =
        glm::dot(memory_->transition.kept_view.forward, frame_->picture.camera.view.forward) < kMinTurnCosine ||
        glm::dot(memory_->transition.kept_view.right, frame_->picture.camera.view.right) < kMinTurnCosine;
    memory_->transition.fade_lasts = share > 0 && share <= 1 && !has_turned && !has_warning();
    return memory_->transition.fade_lasts ? share : 0;
}

}  // namespace tedavis::display
