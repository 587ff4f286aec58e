#include "render_core/policy/failure_policy.hpp"

#include <cmath>

#include "render_core/policy/guidance_decisions.hpp"
#include "render_core/policy/notice_table.hpp"

namespace tedavis::policy {
namespace {

using base::SignalState;
using flight::Signal;

constexpr double kSlowestFlightPath_mps = 10;  // below, the direction of motion on the ground is noise

/// Of a position that is not valid.
RecordFlag own_ship_flag(SignalState state) {
    switch (state) {
        case SignalState::missing: return RecordFlag::own_ship_missing;
        case SignalState::stale: return RecordFlag::own_ship_stale;
        case SignalState::lost: return RecordFlag::own_ship_lost;
        case SignalState::valid:
        case SignalState::invalid: break;
    }
    return RecordFlag::own_ship_invalid;
}

bool is_beyond(const flight::AttitudeExcursion& excursion, const design::UnusualAttitudeLimits& limits) {
    return excursion.pitch_up_rad > limits.pitch_up_rad || excursion.pitch_down_rad > limits.pitch_down_rad ||
           excursion.bank_rad > limits.roll_rad;
}

/// The states of one frame, and the decisions as they are made.
class Policy {
public:
    Policy(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
           const design::DesignSettings& design)
        : state_(state), groups_(state, now), conditions_(conditions), design_(design) {}

    DisplayDecisions decide() {
        for (std::size_t i = 0; i < kGroupCount; ++i)
            if (counts_for_guidance(groups_, static_cast<SignalGroup>(i))) apply(static_cast<SignalGroup>(i));
        decide_attitude();
        decide_heading();
        decide_map();
        decide_element(Element::airspeed, SignalGroup::airspeed);
        decide_element(Element::altitude, SignalGroup::altitude);
        decide_airspeed_trend();
        decide_element(Element::vertical_speed, SignalGroup::vertical_speed);
        decide_element(Element::baro_setting, SignalGroup::baro_setting);
        decide_element(Element::ground_height, SignalGroup::ground_height);
        decide_on_ground();
        out_[Element::wind] = groups_.worse_of(SignalGroup::wind_speed, SignalGroup::wind_direction);
        decide_element(Element::outside_temperature, SignalGroup::outside_temperature);
        policy::decide_guidance(groups_, conditions_.phase.phase.scenario, out_);
        if (decide_minimums(groups_, conditions_.phase.phase.scenario, out_)) flag(RecordFlag::minimum_below_ground);
        check_own_ship();
        check_accuracy(Signal::horizontal_accuracy, design_.degradation.horizontal_accuracy_m,
                       RecordFlag::horizontal_accuracy_above_limit);
        check_accuracy(Signal::vertical_accuracy, design_.degradation.vertical_accuracy_m,
                       RecordFlag::vertical_accuracy_above_limit);
        decide_terrain();
        if (conditions_.databases != base::Currency::current) flag(RecordFlag::database_out_of_date);
        decide_flight_path();
        add_notices();
        return out_;
    }

private:
    [[nodiscard]] SignalState state_of(Signal signal) const { return groups_.state_of(signal); }
    [[nodiscard]] bool valid(Signal signal) const { return groups_.valid(signal); }
    [[nodiscard]] static bool aims_view(SignalGroup group) {
        return group == SignalGroup::pitch || group == SignalGroup::roll || group == SignalGroup::view_heading;
    }
    /// An altitude on a known setting places the terrain well enough to show it, not to colour it.
    [[nodiscard]] bool height_is_on_qnh() const {
        return state_.own_ship.height_is_on_qnh && valid(Signal::baro_altitude) && valid(Signal::baro_setting);
    }
    void add_flag(std::string_view name) {
        const bool added = out_.flags.try_push_back(name);
        TEDAVIS_CHECK(added);
    }
    void flag(RecordFlag flag) { add_flag(name_of(flag)); }
    void flag(Signal signal, SignalState state) {
        base::FixedString<47> name(to_string(signal));
        name.append(".");
        name.append(to_string(state));
        add_flag(name.view());
    }

    /// Gathers the consequences of all signals of the group and names those that went bad.
    void apply(SignalGroup group) {
        const bool served = groups_.has_valid(group);
        for (const SignalRule& rule : signal_rules()) {
            if (rule.group != group) continue;
            const SignalState state = state_of(rule.signal);
            std::uint8_t bits = consequences(rule, state);
            if (state_.is_posed && state == SignalState::missing && (bits & kRemoveTerrain) == 0) bits = kNoConsequence;
            if (group == SignalGroup::geometric_height && height_is_on_qnh()) bits &= ~kDegradeTerrain;
            if (conditions_.is_map && aims_view(group)) bits &= ~kRemoveTerrain;
            if (!served) groups_.add_consequences(group, bits);
            if ((bits & kFlag) != 0 && (!served || state != SignalState::missing)) flag(rule.signal, state);
        }
        all_gathered_ |= groups_.consequences_of(group);
    }
    void decide_element(Element element, SignalGroup group) { out_[element] = groups_.decision(group); }

    void decide_attitude() {
        const ElementDecision pitch = groups_.decision(SignalGroup::pitch), roll = groups_.decision(SignalGroup::roll);
        out_[Element::attitude] = pitch.show == ElementShow::failed ? pitch : roll.show == ElementShow::normal ? pitch : roll;
        if (out_[Element::attitude].show == ElementShow::failed) return;
        // The recovery picture is of the attitude, which the map does not show.
        flight::AttitudeExcursion excursion = state_.excursion;
        excursion.step(groups_.value(Signal::pitch), groups_.value(Signal::roll));
        out_.unusual_attitude = !conditions_.is_map && is_beyond(excursion, design_.unusual_attitude);
        if (out_.unusual_attitude) flag(RecordFlag::attitude_unusual);
    }

    /// Only of the airspeed that is shown.
    void decide_airspeed_trend() {
        const ElementDecision& airspeed = out_[Element::airspeed];
        const bool fits = airspeed.show == ElementShow::normal && valid(Signal::airspeed_rate);
        out_[Element::airspeed_trend] = {fits ? ElementShow::normal : ElementShow::absent,
                                         fits ? Signal::airspeed_rate : Signal::count_};
    }

    /// By the height of the wheels that a radio altimeter measures. A terrain database is not that exact: by its height only in a
    /// phase of the ground, so that no flare and no error of the database takes the warnings of low speeds away.
    void decide_on_ground() {
        constexpr double kMeasured_m = 1, kComputed_m = 5;
        const ElementDecision& ground = out_[Element::ground_height];
        if (ground.show != ElementShow::normal) return;
        const double height_m = state_[ground.source].value_or(0);
        const flight::FlightPhase phase = conditions_.phase.phase;
        const bool rolls =
            phase.scenario == flight::Scenario::ground || phase == flight::kTakeoffStart || phase == flight::kApproachLanding;
        out_.is_on_ground = ground.source == Signal::radio_height ? height_m < kMeasured_m : rolls && height_m < kComputed_m;
    }

    void decide_heading() {
        decide_element(Element::heading, SignalGroup::view_heading);
        for (Signal heading : {Signal::true_heading, Signal::magnetic_heading, Signal::true_track})
            if (out_.view_heading == Signal::count_ && groups_.turns_view(heading)) out_.view_heading = heading;
    }

    void decide_map() {
        const SignalState position = state_.own_ship.state;
        out_[Element::position].show = position == SignalState::valid   ? ElementShow::normal
                                       : position == SignalState::stale ? ElementShow::flagged
                                                                        : ElementShow::failed;
        ElementDecision& up = out_[Element::map_up];
        up.show = out_[Element::position].show == ElementShow::failed ? ElementShow::absent : ElementShow::normal;
        if (up.show == ElementShow::absent || design_.view.map_orientation != design::MapOrientation::track_up) return;
        up.source = valid(Signal::true_track) ? Signal::true_track : out_.view_heading;
        if (up.source == Signal::true_track) return;
        up.show = up.source == Signal::count_ ? ElementShow::flagged : ElementShow::substituted;
        if (conditions_.is_map) flag(up.source == Signal::count_ ? RecordFlag::map_north_up : RecordFlag::map_heading_up);
    }

    void check_own_ship() {
        const SignalState state = state_.own_ship.state;
        if (state != SignalState::valid) {
            all_gathered_ |= kRemoveTerrain;
            flag(own_ship_flag(state));
        } else if (!state_.own_ship.height_is_geometric) {
            all_gathered_ |= kRemoveWarningColors;
            if (!height_is_on_qnh()) all_gathered_ |= kDegradeTerrain;
            flag(height_is_on_qnh() ? RecordFlag::own_ship_height_on_qnh : RecordFlag::own_ship_height_not_geometric);
        }
    }

    void check_accuracy(Signal accuracy, double limit_m, RecordFlag above_limit) {
        if (!valid(accuracy) || state_[accuracy].value_or(0) <= limit_m) return;
        all_gathered_ |= kRemoveWarningColors | kDegradeTerrain;
        flag(above_limit);
    }

    void decide_terrain() {
        const bool known = (all_gathered_ & kRemoveTerrain) == 0;
        out_.show_terrain = known && conditions_.terrain == TerrainSource::ready;
        out_.terrain_degraded = out_.show_terrain && (all_gathered_ & kDegradeTerrain) != 0;
        out_.show_warning_colors =
            out_.show_terrain && design_.warning_colors && !out_.unusual_attitude && (all_gathered_ & kRemoveWarningColors) == 0;
        out_.plain_horizon = !conditions_.is_map && !out_.show_terrain && out_[Element::attitude].show != ElementShow::failed;
        out_.below_terrain = conditions_.terrain == TerrainSource::above_own_ship && !is_parked();
        out_.terrain_ahead = knows_terrain_ahead() ? conditions_.terrain_ahead : TerrainAhead::none;
        out_.obstacle_ahead = knows_terrain_ahead() ? conditions_.obstacle_ahead : TerrainAhead::none;
        if (out_.terrain_ahead != TerrainAhead::none) flag(RecordFlag::terrain_ahead);
        if (out_.obstacle_ahead != TerrainAhead::none) flag(RecordFlag::obstacle_ahead);
        if (out_.terrain_degraded) flag(RecordFlag::terrain_degraded);
        ElementDecision& ground = out_[Element::ground_height];
        if (out_.terrain_degraded && ground.source == Signal::height_above_terrain) ground.show = ElementShow::substituted;
        if (conditions_.terrain == TerrainSource::none) flag(RecordFlag::terrain_missing);
        if (conditions_.terrain == TerrainSource::outside) flag(RecordFlag::terrain_outside_database);
        if (conditions_.terrain == TerrainSource::failed) flag(RecordFlag::terrain_failed);
        if (conditions_.terrain == TerrainSource::over_budget) flag(RecordFlag::terrain_over_budget);
        if (conditions_.terrain == TerrainSource::too_coarse) flag(RecordFlag::terrain_too_coarse);
        if (conditions_.terrain == TerrainSource::above_own_ship) flag(RecordFlag::terrain_above_own_ship);
        if (out_.show_terrain && conditions_.terrain_ends) flag(RecordFlag::terrain_ends);
        if (out_.show_terrain && conditions_.terrain_is_coarse) flag(RecordFlag::terrain_coarse);
        if (out_.show_terrain && conditions_.image_is_missing) flag(RecordFlag::terrain_no_image);
        if (is_flat()) flag(RecordFlag::terrain_flat);
        if (state_.traffic.is_cut) flag(RecordFlag::traffic_cut);
        if (out_.show_terrain && conditions_.data_are_out_of_date) flag(RecordFlag::data_out_of_date);
        if (out_.show_terrain && conditions_.data_are_stale) flag(RecordFlag::data_stale);
    }

    /// Heights of the database are known whatever is shown of it, and obstacles are judged with them; the own ship's place and
    /// height must be trustworthy.
    [[nodiscard]] bool knows_terrain_ahead() const {
        const TerrainSource source = conditions_.terrain;
        const bool has_heights = source == TerrainSource::ready || source == TerrainSource::too_coarse ||
                                 source == TerrainSource::over_budget || source == TerrainSource::outside;
        return has_heights && state_.own_ship.state == SignalState::valid && (all_gathered_ & kDegradeTerrain) == 0;
    }

    /// It stands on ground of which it or the database is a little off.
    [[nodiscard]] bool is_parked() const {
        constexpr double kDeepest_m = 30;
        const flight::OwnShipEstimate& own = state_.own_ship;
        return std::hypot(own.velocity_north_mps, own.velocity_east_mps) < TerrainWatch::kSlowest_mps &&
               state_[Signal::height_above_terrain].value_or(0) >= -kDeepest_m;
    }

    [[nodiscard]] bool is_flat() const { return out_.show_terrain && design_.view.reference == design::Reference::flat; }

    void decide_flight_path() {
        const flight::OwnShipEstimate& own = state_.own_ship;
        ElementDecision& path = out_[Element::flight_path];
        const bool known = own.state == SignalState::valid && out_[Element::attitude].show == ElementShow::normal &&
                           out_.view_heading != Signal::count_;
        const double speed_mps = std::hypot(own.velocity_north_mps, own.velocity_east_mps);
        if (!known)
            path.show = ElementShow::failed;
        else
            path.show = speed_mps < kSlowestFlightPath_mps || out_.unusual_attitude ? ElementShow::absent : ElementShow::normal;
    }

    void notice_if(bool holds, NoticeId id) {
        if (!holds) return;
        const NoticeRow& row = notice_row(id);
        const bool added = out_.notices.try_push_back({row.level, row.text});
        TEDAVIS_CHECK(added);
    }

    /// In the order of their ids.
    void add_notices() {
        const TerrainSource source = conditions_.terrain;
        notice_if(source == TerrainSource::failed, NoticeId::terrain_failed);
        notice_if(out_.below_terrain, NoticeId::below_terrain_flying);
        notice_if(out_.terrain_ahead == TerrainAhead::warning, NoticeId::terrain_ahead_warning);
        notice_if(out_.obstacle_ahead == TerrainAhead::warning, NoticeId::obstacle_ahead_warning);
        notice_if(out_.terrain_ahead == TerrainAhead::caution, NoticeId::terrain_ahead_caution);
        notice_if(out_.obstacle_ahead == TerrainAhead::caution, NoticeId::obstacle_ahead_caution);
        add_position_notices();
        notice_if(source == TerrainSource::none, NoticeId::no_terrain_data);
        notice_if(source == TerrainSource::outside, NoticeId::outside_database);
        notice_if(source == TerrainSource::above_own_ship && !out_.below_terrain, NoticeId::below_terrain_parked);
        notice_if(out_.terrain_degraded, NoticeId::terrain_degraded);
        notice_if(out_.show_terrain && conditions_.terrain_is_coarse, NoticeId::terrain_coarse);
        const bool is_removed_by_signal = source == TerrainSource::ready && !out_.show_terrain;
        notice_if(is_removed_by_signal || source == TerrainSource::over_budget || source == TerrainSource::too_coarse,
                  NoticeId::terrain_off);
        notice_if(conditions_.is_map && out_[Element::map_up].show == ElementShow::flagged, NoticeId::map_north_up);
        notice_if(out_.radio_minimum == MinimumsState::at_or_below || out_.baro_minimum == MinimumsState::at_or_below,
                  NoticeId::minimums);
        add_phase_notices();
        notice_if(conditions_.databases == base::Currency::expired, NoticeId::database_expired);
        notice_if(conditions_.databases == base::Currency::not_yet_valid, NoticeId::database_not_yet_valid);
        notice_if(out_.show_terrain && conditions_.data_are_out_of_date, NoticeId::data_out_of_date);
        notice_if(out_.show_terrain && conditions_.data_are_stale, NoticeId::data_stale);
        notice_if(shows_measure(), NoticeId::analysis_overlay);
        notice_if(state_.traffic.is_cut, NoticeId::traffic_incomplete);
        add_information();
    }

    void add_position_notices() {
        const SignalState position = state_.own_ship.state;
        const bool has_position = position == SignalState::valid && groups_.has_valid(SignalGroup::latitude) &&
                                  groups_.has_valid(SignalGroup::longitude);
        notice_if(position == SignalState::stale, NoticeId::position_stale);
        notice_if(position != SignalState::stale && !has_position, NoticeId::no_position);
    }

    /// Nothing lies over the recovery picture.
    [[nodiscard]] bool shows_measure() const { return conditions_.shows_measure && out_.show_terrain && !out_.unusual_attitude; }

    void add_phase_notices() {
        if (conditions_.phase.switch_fault) flag(RecordFlag::phase_switch_fault);
        notice_if(conditions_.phase.switch_fault, NoticeId::phase_switch_fault);
        if (conditions_.phase.disagreement) flag(RecordFlag::phase_disagreement);
        notice_if(conditions_.phase.disagreement, NoticeId::phase_disagreement);
    }

    void add_information() {
        notice_if(out_.show_terrain && conditions_.terrain_ends, NoticeId::database_ends);
        notice_if(out_.show_terrain && conditions_.image_is_missing, NoticeId::no_terrain_image);
        notice_if(conditions_.is_map && design_.view.mode == design::ViewMode::orthographic, NoticeId::orthographic_view);
        notice_if(is_flat(), NoticeId::flat_ground);
        notice_if(conditions_.is_reduced, NoticeId::graphics_reduced);
        notice_if(conditions_.generated_flight, NoticeId::generated_flight);
        notice_if(true, NoticeId::not_for_navigation);
    }

    const flight::AircraftState& state_;
    GroupDecisions groups_;
    const DisplayConditions& conditions_;
    const design::DesignSettings& design_;
    std::uint8_t all_gathered_ = 0;
    DisplayDecisions out_;
};

}  // namespace

DisplayDecisions decide_display(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
                                const design::DesignSettings& design) noexcept {
    return Policy(state, now, conditions, design).decide();
}

}  // namespace tedavis::policy
