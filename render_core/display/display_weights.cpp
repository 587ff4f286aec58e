// What of the display weighs the aspects of a frame: the design's weights, what raises them, and the picture that they leave.
#include <cmath>

#include "render_core/design/weighted_design.hpp"
#include "render_core/display/data_legends.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/hazard_watch.hpp"
#include "render_core/display/terrain_ground.hpp"

namespace tedavis::display {

/// Before anything of the frame is planned.
void Display::weigh(base::Time now) {
    const design::AspectWeights weights = weights_at(now);
    if (weights == weights_) return;
    weights_ = weights;
    take_weights();
    has_new_look_ = true;
}

/// At other weights than the stated ones it has the programs of the design as it was read.
void Display::take_weights() {
    const design::PrioritySettings& priority = design_at(shown_).priority;
    settings_.design = design_at(shown_);
    design::weigh(weights_, settings_.design);
    if (!(weights_ == priority.weights)) design::keep_programs(design_at(shown_), settings_.design);
    if (elements_.is_started()) set_elements();
}

void Display::show_look() {
    has_new_look_ = false;
    const draw::DrawnDesign drawn = drawn_design(settings_.design, draws_foci_);
    passes_.set_design(drawn);
    terrain_.set_design(gl_, drawn);
}

design::AspectWeights Display::weights_at(base::Time now) {
    const design::PrioritySettings& priority = design_at(shown_).priority;
    design::AspectWeights weights = priority.weights;
    has_hazard_ = false;
    if (!priority.is_stated) return weights;
    double& uncertainty = weights.of[design::kUncertaintyAspect];
    if (data_are_stale(flight::flight_time(state_.utc, now))) uncertainty = std::fmax(uncertainty, priority.stale_uncertainty);
    if (terrain_.is_started() && state_.own_ship.state == base::SignalState::valid) raise_hazards(priority, now, weights);
    return weights;
}

void Display::raise_hazards(const design::PrioritySettings& priority, base::Time now, design::AspectWeights& weights) {
    const flight::OwnShipEstimate& own = state_.own_ship;
    Way way{own.position, own.velocity_north_mps, own.velocity_east_mps, own.velocity_up_mps};
    if (!own.height_is_geometric) way.from.height.m += undulation_m(own.position);
    TerrainGround ground(terrain_, terrain::View());
    const flight::FlightTime time = flight::flight_time(state_.utc, now);
    HazardWatch watch(priority, way, ground, time.utc.ns);
    const auto raise = [&](std::size_t aspect, double share) {
        double& weight = weights.of[aspect];
        weight = std::fmax(weight, weight + share * (priority.hazard_weight - weight));
    };
    // Where terrain comes first already it needs no focus of its own.
    if (weights.of[design::kTerrainAspect] < priority.hazard_weight) raise(design::kTerrainAspect, watch.terrain_share());
    for (std::size_t n = 0; n < priority.parts.size() && data_.has_scene(); ++n)
        for (const scene::Layer& layer : data_.scene().layers())
            if (priority.parts[n].is_hazard && priority.parts[n].has(layer.entry->role) &&
                layer.entry->shape != scene::LayerShape::grid && is_valid_at(layer, time))
                raise(design::kMainAspects + n, watch.layer_share(layer));
    has_hazard_ = watch.first_met(hazard_);
}

/// Of what the design shows: measured so long ago that it is said to be stale, or out of date.
bool Display::data_are_stale(const flight::FlightTime& time) const {
    if (!data_.has_scene() || !time.is_confirmed) return false;
    const design::DataStyle& data = design_at(shown_).data;
    for (const scene::Layer& layer : data_.scene().layers()) {
        bool is_shown = data.ground.is_shown && data.ground.layer.view() == layer.entry->name;
        for (const design::DataElement& element : data.elements) is_shown = is_shown || is_meant(element, layer);
        if (is_shown && (!is_valid_at(layer, time) || is_stale(layer, time, data.stale_after_s))) return true;
    }
    return false;
}

/// What is shown without strength is not asked for.
effects::EffectSet Display::asked() const {
    effects::EffectSet asked = asked_of_[shown_];
    const bool was_asked = design_at(shown_).terrain.style.sketch.silhouettes > 0;
    if (was_asked && settings_.design.terrain.style.sketch.silhouettes <= 0) asked.remove(effects::Effect::silhouettes);
    return asked;
}

}  // namespace tedavis::display
