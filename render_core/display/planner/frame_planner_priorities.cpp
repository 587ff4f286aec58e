// Priorities of a frame: the design's weights, what raises them, and which data are stale.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/design/band_widening.hpp"
#include "render_core/design/weighted_design.hpp"
#include "render_core/display/planner/data_legends.hpp"
#include "render_core/display/planner/frame_notes.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/planner/symbology_plan.hpp"
#include "render_core/display/planner/terrain_ground.hpp"
#include "render_core/policy/hazard_watch.hpp"
#include "render_core/policy/obstacle_ahead.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::display {

using flight::Signal;

namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();

bool is_obstacles(const scene::Layer& layer) {
    const scene::LayerShape shape = layer.entry->shape;
    return layer.entry->role == scene::LayerRole::obstacle &&
           (shape == scene::LayerShape::points || shape == scene::LayerShape::lines);
}

/// A turn may end at any time, so terrain and obstacles straight ahead count as well, with twice their time.
policy::TerrainWatchInput straight(policy::TerrainWatchInput watched) {
    watched.track.turn_radps = 0;
    return watched;
}

}  // namespace

/// Of the design that is shown.
class FramePlanner::Boosts final : public policy::BoostSource {
public:
    explicit Boosts(FramePlanner& planner) : planner_(planner), priority_(planner.design_at(planner.memory_->shown).priority) {}

    [[nodiscard]] policy::PriorityBoosts boosts_at(const policy::PriorityInstant& instant) override {
        policy::PriorityBoosts boosts;
        find_alerts(instant, boosts);
        if (!priority_.is_stated) return boosts;
        if (planner_.data_are_stale(instant.time)) boost(boosts, design::kUncertaintyAspect, 1, priority_.stale_uncertainty);
        if (planner_.terrain_.is_started() && instant.own_ship.state == base::SignalState::valid) boost_hazards(instant, boosts);
        return boosts;
    }

private:
    void find_alerts(const policy::PriorityInstant& instant, policy::PriorityBoosts& boosts) const {
        if (!planner_.terrain_.is_started() || instant.own_ship.state != base::SignalState::valid) return;
        const policy::TerrainWatchInput watched = planner_.watched(instant);
        const bool is_low = !is_above_all(watched);
        if (!is_low && !has_obstacles()) return;
        TerrainGround ground(planner_.terrain_, terrain::View());
        policy::TerrainWatch watch(watched, ground, ground), ahead(straight(watched), ground, ground);
        const bool turns = watched.track.turn_radps != 0;
        boosts.terrain_watch = {watch.is_watching(), watch.clearance_m()};
        if (is_low)
            boosts.terrain_ahead = policy::level_within(
                policy::counted_s(watch.seconds_to_terrain(), turns ? ahead.seconds_to_terrain() : kNever_s));
        policy::ObstacleWatch obstacles(watch, ground), obstacles_ahead(ahead, ground);
        for (std::size_t n = 0; planner_.data_.has_scene() && n < planner_.data_.scene().layers().size(); ++n) {
            const scene::Layer& layer = planner_.data_.scene().layers()[n];
            if (!is_obstacles(layer) || !is_valid_at(layer, instant.time)) continue;
            for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature)
                boosts.obstacles.add(static_cast<std::uint16_t>(n), feature, obstacles.seconds_to(layer, feature),
                                     turns ? obstacles_ahead.seconds_to(layer, feature) : kNever_s);
        }
    }

    [[nodiscard]] bool has_obstacles() const {
        if (!planner_.data_.has_scene()) return false;
        const base::Span<const scene::Layer> layers = planner_.data_.scene().layers();
        return std::any_of(layers.begin(), layers.end(), is_obstacles);
    }

    /// So that nothing need be read of the database.
    [[nodiscard]] bool is_above_all(const policy::TerrainWatchInput& watched) const {
        constexpr double kMargin_m = 50;  // by which the geoid differs along the track at most
        constexpr double kAhead_s = policy::TerrainWatch::kLookAhead_s;
        const policy::PredictedTrack& track = watched.track;
        const double lowest_m = std::fmin(track.from.height.m, track.at(kAhead_s).height.m) - watched.uncertainty.height_m -
                                watched.uncertainty.climb_mps * kAhead_s;
        const double highest_m =
            double{planner_.terrain_.database().header().max_height_m} + planner_.undulation_m(track.from) + kMargin_m;
        return lowest_m > highest_m + policy::required_clearance_m({flight::Scenario::cruise, 0}, 0);
    }

    void boost(policy::PriorityBoosts& boosts, std::size_t aspect, double share, double weight) const {
        boosts.of[aspect] = std::fmax(boosts.of[aspect], share * (weight - priority_.weights.of[aspect]));
    }

    void boost_hazards(const policy::PriorityInstant& instant, policy::PriorityBoosts& boosts) const {
        const policy::PredictedTrack track = planner_.track_of(instant.own_ship);
        TerrainGround ground(planner_.terrain_, terrain::View());
        policy::HazardWatch watch(priority_, track, ground, instant.time.utc.ns);
        // Where terrain already has priority it needs no focus of its own.
        if (priority_.weights.of[design::kTerrainAspect] < priority_.hazard_weight)
            boost(boosts, design::kTerrainAspect, watch.terrain_share(), priority_.hazard_weight);
        for (std::size_t n = 0; n < priority_.parts.size() && planner_.data_.has_scene(); ++n)
            for (const scene::Layer& layer : planner_.data_.scene().layers())
                if (is_hazard(n, layer, instant.time))
                    boost(boosts, design::kMainAspects + n, share_of(layer, boosts, watch), priority_.hazard_weight);
        boosts.has_hazard = watch.first_met(boosts.hazard);
    }

    /// Obstacles are a hazard where they are alerted.
    [[nodiscard]] static double share_of(const scene::Layer& layer, const policy::PriorityBoosts& boosts,
                                         policy::HazardWatch& watch) {
        return is_obstacles(layer) ? watch.share_at(boosts.obstacles.soonest_s()) : watch.layer_share(layer);
    }

    [[nodiscard]] bool is_hazard(std::size_t part, const scene::Layer& layer, const flight::FlightTime& time) const {
        return priority_.parts[part].is_hazard && priority_.parts[part].has(layer.entry->role) &&
               layer.entry->shape != scene::LayerShape::grid && is_valid_at(layer, time);
    }

    FramePlanner& planner_;
    const design::PrioritySettings& priority_;
};

policy::PredictedTrack FramePlanner::track_of(const flight::OwnShipEstimate& own) const {
    policy::PredictedTrack track{own.position, own.velocity_north_mps, own.velocity_east_mps, own.velocity_up_mps};
    if (!own.height_is_geometric) track.from.height.m += undulation_m(own.position);
    return track;
}

/// Returns the rate of turn by the signal, or by the bank in a coordinated turn; 0 where neither is valid.
double FramePlanner::turn_radps() const {
    const flight::AircraftState& state = frame_->state;
    if (state.is_valid(Signal::heading_rate, frame_->time)) {
        const double rate_radps = state[Signal::heading_rate].value_or(0);
        return std::isfinite(rate_radps) ? rate_radps : 0;
    }
    const double speed_mps = std::hypot(state.own_ship.velocity_north_mps, state.own_ship.velocity_east_mps);
    const double roll_rad = state[Signal::roll].value_or(0);
    if (!state.is_valid(Signal::roll, frame_->time) || !(std::fabs(roll_rad) < base::radians(75)) || !(speed_mps > 1)) return 0;
    return base::kStandardGravity * std::tan(roll_rad) / speed_mps;
}

/// As stated, or assumed; heights with the terrain's, whatever a design says of its bands.
policy::TrackUncertainty FramePlanner::track_uncertainty() const {
    policy::TrackUncertainty uncertainty;
    const double stated_m = frame_->state[Signal::horizontal_accuracy].value_or(0);
    if (frame_->state.is_valid(Signal::horizontal_accuracy, frame_->time) && stated_m > 0)
        uncertainty.position_m = std::fmax(stated_m, policy::kMinPositionUncertainty_m);
    design::HeightAccuracy accuracy = height_accuracy();
    if (!frame_->state.own_ship.height_is_geometric) accuracy.position_m = 0;  // the receiver's is not the altimeter's
    const design::WideningSettings settings;
    uncertainty.height_m = design::band_widening(settings, design::deviations_of_coverage(settings.coverage), accuracy).lowered_m;
    return uncertainty;
}

policy::PriorityInstant FramePlanner::priority_instant() const {
    return {frame_->time,           flight::flight_time(frame_->state.utc, frame_->time),
            frame_->state.own_ship, frame_->conditions.phase.presented,
            turn_radps(),           terrain_.is_started() ? track_uncertainty() : policy::TrackUncertainty{}};
}

policy::TerrainWatchInput FramePlanner::watched(const policy::PriorityInstant& instant) const {
    policy::TerrainWatchInput input;
    input.track = track_of(instant.own_ship);
    input.track.turn_radps = instant.turn_radps;
    input.uncertainty = instant.uncertainty;
    input.phase = instant.phase;
    if (data_.has_scene()) input.layers = data_.scene().layers();
    return input;
}

/// Plans the zone that an alert colours, from the present position of the own ship along the track that reaches terrain first.
/// Like warning colours it needs a geometric height, and it is not shown during the recovery from an unusual attitude.
void FramePlanner::plan_alert_zone() {
    const policy::DisplayDecisions& decisions = frame_->decisions;
    if (decisions.terrain_ahead == policy::TerrainAhead::none || !decisions.show_terrain || decisions.unusual_attitude) return;
    if (!frame_->state.own_ship.height_is_geometric) return;
    TerrainGround ground(terrain_, terrain::View());
    const policy::TerrainWatchInput turning = watched(priority_instant());
    policy::TerrainWatch watch(turning, ground, ground), ahead(straight(turning), ground, ground);
    const double on_track_s = watch.seconds_to_terrain(), counted_s = policy::counted_s(on_track_s, ahead.seconds_to_terrain());
    frame_->alert_zone = (counted_s < on_track_s ? ahead : watch).zone(decisions.terrain_ahead);
}

/// Writes the alerts into the record.
void FramePlanner::state_alerts() {
    AlertRecord& alerts = frame_->alerts;
    alerts = {};
    alerts.terrain = frame_->decisions.terrain_ahead;
    alerts.obstacle = frame_->decisions.obstacle_ahead;
    if (alerts.obstacle != policy::TerrainAhead::none) alerts.obstacles = memory_->boost.obstacles();
    alerts.height_above_terrain_m = frame_->state[Signal::height_above_terrain].value_or(std::nan(""));
    alerts.is_watching = memory_->boost.terrain_watch().is_watching;
    alerts.clearance_m = memory_->boost.terrain_watch().clearance_m;
}

/// Before anything of the frame is planned.
void FramePlanner::apply_priorities() {
    design::AspectWeights weights = design_at(memory_->shown).priority.weights;
    if (has_intervals_) {
        Boosts boosts(*this);
        memory_->boost.follow(priority_instant(), boosts, memory_->shown);
        if (design_at(memory_->shown).priority.is_stated) weights = memory_->boost.above(weights);
    }
    frame_->conditions.terrain_ahead = memory_->boost.terrain_ahead();
    frame_->conditions.obstacle_ahead = memory_->boost.obstacles().level();
    if (weights == memory_->weights) return;
    memory_->weights = weights;
    take_look(asked_look());
}

ObstaclePlaces FramePlanner::obstacles_ahead(const PlannedFrame& frame, const PlannerMemory& memory) {
    if (!elements_.is_started() || !frame.decisions.show_terrain || !data_.has_scene() ||
        frame.state.own_ship.state != base::SignalState::valid)
        return {};
    const policy::PredictedTrack track = track_of(frame.state.own_ship);
    TerrainGround ground(terrain_, frame.picture.camera.view);
    policy::HazardWatch watch(design_at(memory.shown).priority, track, ground, frame.flight_time.utc.ns);
    terrain::LineOfSight sight = terrain_.sight(frame.picture.camera.view);
    const draw::SignView eye{frame.picture.camera.view, static_cast<float>(text_px(context_of(frame, frame.picture.camera),
                                                                                   settings_.width_px, settings_.height_px))};
    return obstacle_places({data_.scene(), frame.flight_time, ground, eye, &sight, elements_.reports(), elements_.labels()},
                           watch);
}

namespace {

/// A map beside the picture that names no layer has the first grid of its role.
bool shows_beside(const design::AdjacentView& maps, const scene::Layer& layer) {
    if (!maps.layer.empty()) return maps.layer.view() == layer.entry->name;
    return layer.entry->shape == scene::LayerShape::grid && layer.entry->role == maps.role;
}

}  // namespace

bool FramePlanner::is_in_design(const scene::Layer& layer) const {
    const design::DataStyle& data = design_at(memory_->shown).data;
    bool is_shown = (data.ground.is_shown && data.ground.layer.view() == layer.entry->name) ||
                    (data.adjacent.is_shown && shows_beside(data.adjacent, layer));
    for (const design::DataElement& element : data.elements) is_shown = is_shown || is_meant(element, layer);
    return is_shown;
}

/// Each layer of the picture that is stale, and each that values of it were made of.
void FramePlanner::state_stale_data() {
    if (!data_.has_scene() || !frame_->flight_time.is_confirmed || !frame_->decisions.show_terrain) return;
    const double stale_after_s = design_at(memory_->shown).data.stale_after_s;
    for (const scene::Layer& layer : data_.scene().layers()) {
        if (!is_in_design(layer) || !is_valid_at(layer, frame_->flight_time)) continue;
        record_stale(layer.entry->name, stale_age(layer, frame_->flight_time, stale_after_s), *frame_);
        for (const scene::Attribute& attribute : layer.attributes)
            if (const std::uint8_t from = attribute.entry->derived_from; from > 0)
                state_stale_source(data_.scene().layers()[from - 1], *attribute.entry, stale_after_s);
    }
}

/// Of one instant of a layer that an attribute was made of, or of what the layer holds of this date.
void FramePlanner::state_stale_source(const scene::Layer& source, const scene::AttributeEntry& made, double stale_after_s) {
    constexpr std::int64_t kMinute_ns = 60'000'000'000;
    base::Duration age = stale_age(source, frame_->flight_time, stale_after_s);
    if (made.derived_minute > 0) {
        age.ns = frame_->flight_time.utc.ns - made.derived_minute * kMinute_ns;
        if (age.to_seconds() <= stale_after_s) return;
    }
    record_stale(source.entry->name, age, *frame_);
}

/// Of what the design shows: measured so long ago that it is said to be stale, or out of date.
bool FramePlanner::data_are_stale(const flight::FlightTime& time) const {
    if (!data_.has_scene() || !time.is_confirmed) return false;
    const double stale_after_s = design_at(memory_->shown).data.stale_after_s;
    for (const scene::Layer& layer : data_.scene().layers())
        if (is_in_design(layer) && (!is_valid_at(layer, time) || stale_age(layer, time, stale_after_s).ns > 0)) return true;
    return false;
}

/// What is shown without strength is not asked for.
effects::EffectSet FramePlanner::asked() const {
    effects::EffectSet asked = asked_of_[memory_->shown];
    const bool was_asked = design_at(memory_->shown).terrain.style.sketch.silhouettes > 0;
    if (was_asked && look_.terrain.style.sketch.silhouettes <= 0) asked.remove(effects::Effect::silhouettes);
    return asked;
}

}  // namespace tedavis::display
