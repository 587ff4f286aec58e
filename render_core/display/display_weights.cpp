// What of the display weighs the aspects of a frame: the design's weights, what raises them, and the picture that they leave.
#include <cmath>

#include "render_core/design/weighted_design.hpp"
#include "render_core/display/data_legends.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/frame_notes.hpp"
#include "render_core/display/symbology_plan.hpp"
#include "render_core/display/terrain_ground.hpp"
#include "render_core/policy/hazard_watch.hpp"

namespace tedavis::display {

/// Of the design that is shown.
class Display::Raises final : public policy::BoostSource {
public:
    explicit Raises(Display& display) : display_(display), priority_(display.design_at(display.shown_).priority) {}

    [[nodiscard]] policy::PriorityBoosts boosts_at(const policy::PriorityInstant& instant) override {
        policy::PriorityBoosts raises;
        raises.terrain_ahead = terrain_ahead_at(instant);
        if (!priority_.is_stated) return raises;
        if (display_.data_are_stale(instant.time)) raise(raises, design::kUncertaintyAspect, 1, priority_.stale_uncertainty);
        if (display_.terrain_.is_started() && instant.own_ship.state == base::SignalState::valid) raise_hazards(instant, raises);
        return raises;
    }

private:
    [[nodiscard]] policy::TerrainAhead terrain_ahead_at(const policy::PriorityInstant& instant) const {
        if (!display_.terrain_.is_started() || instant.own_ship.state != base::SignalState::valid)
            return policy::TerrainAhead::none;
        const policy::PredictedTrack track = display_.track_of(instant.own_ship);
        if (is_above_all(track)) return policy::TerrainAhead::none;
        TerrainGround ground(display_.terrain_, terrain::View());
        base::Span<const scene::Layer> layers;
        if (display_.data_.has_scene()) layers = display_.data_.scene().layers();
        return policy::TerrainWatch(track, instant.phase, layers, ground).ahead();
    }

    /// So that nothing need be read of the database.
    [[nodiscard]] bool is_above_all(const policy::PredictedTrack& track) const {
        constexpr double kMargin_m = 50;  // by which the geoid differs along the track at most
        const double lowest_m = std::fmin(track.from.height.m, track.at(policy::TerrainWatch::kLookAhead_s).height.m);
        const double highest_m =
            double{display_.terrain_.database().header().max_height_m} + display_.undulation_m(track.from) + kMargin_m;
        return lowest_m > highest_m + policy::required_clearance_m({flight::Scenario::cruise, 0}, 0);
    }

    void raise(policy::PriorityBoosts& raises, std::size_t aspect, double share, double weight) const {
        raises.of[aspect] = std::fmax(raises.of[aspect], share * (weight - priority_.weights.of[aspect]));
    }

    void raise_hazards(const policy::PriorityInstant& instant, policy::PriorityBoosts& raises) const {
        const policy::PredictedTrack track = display_.track_of(instant.own_ship);
        TerrainGround ground(display_.terrain_, terrain::View());
        policy::HazardWatch watch(priority_, track, ground, instant.time.utc.ns);
        // Where terrain comes first already it needs no focus of its own.
        if (priority_.weights.of[design::kTerrainAspect] < priority_.hazard_weight)
            raise(raises, design::kTerrainAspect, watch.terrain_share(), priority_.hazard_weight);
        for (std::size_t n = 0; n < priority_.parts.size() && display_.data_.has_scene(); ++n)
            for (const scene::Layer& layer : display_.data_.scene().layers())
                if (is_hazard(n, layer, instant.time))
                    raise(raises, design::kMainAspects + n, watch.layer_share(layer), priority_.hazard_weight);
        raises.has_hazard = watch.first_met(raises.hazard);
    }

    [[nodiscard]] bool is_hazard(std::size_t part, const scene::Layer& layer, const flight::FlightTime& time) const {
        return priority_.parts[part].is_hazard && priority_.parts[part].has(layer.entry->role) &&
               layer.entry->shape != scene::LayerShape::grid && is_valid_at(layer, time);
    }

    Display& display_;
    const design::PrioritySettings& priority_;
};

policy::PredictedTrack Display::track_of(const flight::OwnShipEstimate& own) const {
    policy::PredictedTrack track{own.position, own.velocity_north_mps, own.velocity_east_mps, own.velocity_up_mps};
    if (!own.height_is_geometric) track.from.height.m += undulation_m(own.position);
    return track;
}

/// Before anything of the frame is planned.
void Display::weigh(base::Time now) {
    design::AspectWeights weights = design_at(shown_).priority.weights;
    if (has_epochs_) {
        Raises raises(*this);
        raised_.follow({now, flight::flight_time(state_.utc, now), state_.own_ship, conditions_.phase.presented}, raises, shown_);
        if (design_at(shown_).priority.is_stated) weights = raised_.above(weights);
    }
    conditions_.terrain_ahead = raised_.terrain_ahead();
    const bool shows_alert = conditions_.terrain_ahead != policy::TerrainAhead::none;
    if (weights == weights_ && shows_alert == shows_alert_) return;
    weights_ = weights;
    shows_alert_ = shows_alert;
    take_weights();
    has_new_look_ = true;
}

/// At other weights than the stated ones it has the programs of the design as it was read. While terrain is ahead it has warning
/// colours, whatever it says of them.
void Display::take_weights() {
    const design::PrioritySettings& priority = design_at(shown_).priority;
    settings_.design = design_at(shown_);
    design::weigh(weights_, settings_.design);
    if (!(weights_ == priority.weights)) design::keep_programs(design_at(shown_), settings_.design);
    if (shows_alert_) design::require_warning_colors(settings_.design);
    if (elements_.is_started()) set_elements();
}

void Display::show_look() {
    has_new_look_ = false;
    const draw::DrawnDesign drawn = drawn_design(settings_.design, draws_foci_);
    passes_.set_design(drawn);
    terrain_.set_design(drawn);
    terrain_painter_.set_design(gl_, drawn);
}

ObstaclePlaces Display::obstacles_ahead() {
    if (!shows_elements() || !data_.has_scene() || state_.own_ship.state != base::SignalState::valid) return {};
    const policy::PredictedTrack track = track_of(state_.own_ship);
    TerrainGround ground(terrain_, eye_.view);
    policy::HazardWatch watch(design_at(shown_).priority, track, ground, record_.flight_time.utc.ns);
    terrain::DrawnSight sight = terrain_.sight(eye_.view);
    const draw::SignView eye{eye_.view, static_cast<float>(text_px(context(), settings_.width_px, settings_.height_px))};
    return obstacle_places({data_.scene(), record_.flight_time, ground, eye, &sight, elements_.reports(), elements_.labels()},
                           watch);
}

namespace {

/// A map beside the picture that names no layer has the first grid of its role.
bool shows_beside(const design::AdjacentView& maps, const scene::Layer& layer) {
    if (!maps.layer.empty()) return maps.layer.view() == layer.entry->name;
    return layer.entry->shape == scene::LayerShape::grid && layer.entry->role == maps.role;
}

}  // namespace

bool Display::is_in_design(const scene::Layer& layer) const {
    const design::DataStyle& data = design_at(shown_).data;
    bool is_shown = (data.ground.is_shown && data.ground.layer.view() == layer.entry->name) ||
                    (data.adjacent.is_shown && shows_beside(data.adjacent, layer));
    for (const design::DataElement& element : data.elements) is_shown = is_shown || is_meant(element, layer);
    return is_shown;
}

/// Each layer of the picture that is stale, and each that values of it were made of.
void Display::note_stale_data() {
    if (!data_.has_scene() || !record_.flight_time.is_confirmed || !decisions_.show_terrain) return;
    const double stale_after_s = design_at(shown_).data.stale_after_s;
    for (const scene::Layer& layer : data_.scene().layers()) {
        if (!is_in_design(layer) || !is_valid_at(layer, record_.flight_time)) continue;
        note_stale(layer.entry->name, stale_age(layer, record_.flight_time, stale_after_s), record_);
        for (const scene::Attribute& attribute : layer.attributes)
            if (const std::uint8_t from = attribute.entry->derived_from; from > 0)
                note_stale_source(data_.scene().layers()[from - 1], *attribute.entry, stale_after_s);
    }
}

/// Of one instant of a layer that an attribute was made of, or of what the layer holds of this date.
void Display::note_stale_source(const scene::Layer& source, const scene::AttributeEntry& made, double stale_after_s) {
    constexpr std::int64_t kMinute_ns = 60'000'000'000;
    base::Duration age = stale_age(source, record_.flight_time, stale_after_s);
    if (made.derived_minute > 0) {
        age.ns = record_.flight_time.utc.ns - made.derived_minute * kMinute_ns;
        if (age.to_seconds() <= stale_after_s) return;
    }
    note_stale(source.entry->name, age, record_);
}

/// Of what the design shows: measured so long ago that it is said to be stale, or out of date.
bool Display::data_are_stale(const flight::FlightTime& time) const {
    if (!data_.has_scene() || !time.is_confirmed) return false;
    const double stale_after_s = design_at(shown_).data.stale_after_s;
    for (const scene::Layer& layer : data_.scene().layers())
        if (is_in_design(layer) && (!is_valid_at(layer, time) || stale_age(layer, time, stale_after_s).ns > 0)) return true;
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
