// The designs of the display: which phase has which, and how one takes the place of another.
#include <glm/geometric.hpp>

#include "render_core/design/weighted_design.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/effect_calls.hpp"

namespace tedavis::display {
namespace {

constexpr double kLeastTurnCosine = 0.9997;  // of a degree and a half

base::Error differing(const design::DesignSettings& one, const design::DesignSettings& other) {
    base::Error error = base::make_error("the designs '", one.name.view(), "' and '", other.name.view());
    error.message.append("' follow one another, so both need aerial perspective, and the same stereo, or neither; change one");
    return error;
}

}  // namespace

base::Error Display::take_designs(const DisplaySettings& settings) {
    if (settings.phases != nullptr) phases_ = *settings.phases;
    settings_.phases = nullptr;
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        const design::DesignSettings& asked = place == 0 ? settings.design : settings.phases->at(place);
        if (const auto order = effects::replacement_order(asked.effects.instead); !order.ok())
            return base::make_error("the design's ", order.error().view());
        asked_of_[place] = asked_effects(asked);
        design::DesignSettings& kept = place == 0 ? design_ : phases_.at(place);
        kept = possible_design(asked, settings_.device);
        if (kept.sky.air.is_shown != design_.sky.air.is_shown || stereo_margin_px(kept) != stereo_margin_px(design_))
            return differing(design_, kept);
    }
    weights_ = design_.priority.weights;
    take_weights();
    band_deviations_ = design::deviations_of_coverage(design_.widening.coverage);
    return {};
}

bool Display::asks_for_rays(const DisplaySettings& settings) {
    bool asks = settings.design.terrain.renderer == design::TerrainRenderer::trace;
    const std::size_t count = settings.phases != nullptr ? settings.phases->size() : 0;
    for (std::size_t place = 1; place <= count; ++place)
        asks = asks || settings.phases->at(place).terrain.renderer == design::TerrainRenderer::trace;
    return asks;
}

draw::DrawnDesign Display::drawn_design(const design::DesignSettings& design, bool has_focus) const {
    return draw::drawn_as(design, settings_.device.capability.depth24_targets, has_focus);
}

/// Where no focus is anywhere the ground is that of a design without foci, by its programs.
void Display::follow_foci() {
    const bool draws = foci_.foci.is_any() && decisions_.show_terrain && !decisions_.unusual_attitude;
    if (draws == draws_foci_) return;
    draws_foci_ = draws;
    has_new_look_ = true;
}

bool Display::can_show(const design::DesignSettings& possible) const {
    const bool is_dimmable = dimmer_.is_started() || possible.effects.lighting == design::PanelLighting::day;
    if (!is_dimmable || !saliency_.shows(possible.effects.saliency) || !clutter_.can_show(possible) ||
        stereo_margin_px(possible) != stereo_.margin_px() || !element_painter_.can_show(possible))
        return false;
    const design::DesignSettings weighted = design::weighted(possible);
    for (const design::DesignSettings* const design : {&weighted, &possible})
        for (const bool has_focus : {false, true}) {
            const draw::DrawnDesign drawn = drawn_design(*design, has_focus);
            if (!passes_.shows(drawn) || !terrain_painter_.shows(drawn)) return false;
        }
    return true;
}

bool Display::set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases) {
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    for (std::size_t place = 0; place <= count; ++place)
        if (!can_show(possible_design(place == 0 ? design : phases->at(place), settings_.device))) return false;
    keep_scene();
    chosen_foci_ = 0;
    phases_ = phases != nullptr ? *phases : design::PhaseDesigns();
    for (std::size_t place = 0; place <= count; ++place) {
        const design::DesignSettings& asked = place == 0 ? design : phases->at(place);
        asked_of_[place] = asked_effects(asked);
        (place == 0 ? design_ : phases_.at(place)) = possible_design(asked, settings_.device);
    }
    forget_turns();
    show_design(0);
    elements_.labels().forget();
    raised_.forget();
    note_epochs();
    return true;
}

/// All designs are judged before any is changed.
bool Display::set_foci(const design::FocusList& chosen) {
    const auto with_chosen = [&](std::size_t place) {
        design::DesignSettings design = design_at(place);
        const design::FocusList before = design.foci;
        design.foci = chosen;
        for (std::size_t n = chosen_foci_; n < before.size(); ++n) static_cast<void>(design.foci.try_push_back(before[n]));
        return design;
    };
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        const std::size_t count = chosen.size() + design_at(place).foci.size() - chosen_foci_;
        if (count > scene::kMaxFoci || !can_show(with_chosen(place))) return false;
    }
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        design::DesignSettings& kept = place == 0 ? design_ : phases_.at(place);
        kept = with_chosen(place);
        asked_of_[place].add(asked_effects(kept));
    }
    chosen_foci_ = chosen.size();
    clutter_.forget();
    show_design(shown_);
    return true;
}

void Display::show_design(std::size_t place) {
    shown_ = place;
    weights_ = design_at(place).priority.weights;
    take_weights();
    show_look();
    band_deviations_ = design::deviations_of_coverage(settings_.design.widening.coverage);
}

/// While there is a warning the picture turns at once: nobody shall look for it in a picture that is half another.
void Display::follow_phase(const flight::PhaseStatus& phase, base::Time now) {
    if (turn_ == Turn::keeps) {
        turn_ = Turn::none;
        begin_fade(turns_at_);
        show_design(turns_to_);
    }
    const std::size_t place = phases_.place_of(phase.presented);
    const bool is_new = is_new_to_phases_;
    is_new_to_phases_ = false;
    if (place == shown_) return;
    if (is_new || !fade_.is_started() || has_warning()) return show_design(place);
    turns_to_ = place;
    turns_at_ = now;
    turn_ = Turn::keeps;
}

/// Of the frame planned last.
bool Display::has_warning() const {
    return decisions_.unusual_attitude || decisions_.terrain_ahead != policy::TerrainAhead::none || !decisions_.show_terrain ||
           conditions_.terrain != policy::TerrainSource::ready;
}

/// What is planned, once more, before it is replaced.
void Display::keep_scene() {
    if (!fade_.is_started() || frame_ == 0) return;
    draw_kept();
    fades_next_ = true;
}

draw::TerrainDrawResult Display::draw_kept() {
    kept_view_ = eye_.view;
    return draw_passes(fade_.target(), eye_);
}

void Display::begin_fade(base::Time now) {
    fade_lasts_ = true;
    fade_began_ = now;
}

/// Of the scene as it was, in the planned frame.
double Display::next_fade_share() {
    if (turn_ == Turn::keeps) return 1;
    if (fades_next_) {
        fades_next_ = false;
        begin_fade(record_.time);
    }
    if (!fade_lasts_) return 0;
    const double share = 1 - (record_.time - fade_began_).to_seconds() / settings_.design.effects.fade_s;
    // A scene that stands still while the horizon turns would mislead.
    const bool has_turned = glm::dot(kept_view_.forward, eye_.view.forward) < kLeastTurnCosine ||
                            glm::dot(kept_view_.right, eye_.view.right) < kLeastTurnCosine;
    fade_lasts_ = share > 0 && share <= 1 && !has_turned && !has_warning();
    return fade_lasts_ ? share : 0;
}

}  // namespace tedavis::display
