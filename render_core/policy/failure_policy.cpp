#include "render_core/policy/failure_policy.hpp"

#include <cmath>

#include "render_core/policy/notice_table.hpp"

namespace tedavis::policy {
namespace {

using base::SignalState;
using flight::NavigationSource;
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

/// The states of one frame, and the decisions as they are made.
class Policy {
public:
    Policy(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
           const design::DesignSettings& design)
        : state_(state), now_(now), conditions_(conditions), design_(design) {}

    DisplayDecisions decide() {
        for (std::size_t i = 0; i < kGroupCount; ++i)
            if (counts(static_cast<SignalGroup>(i))) apply(static_cast<SignalGroup>(i));
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
        decide_wind();
        decide_element(Element::outside_temperature, SignalGroup::outside_temperature);
        decide_guidance();
        decide_minimums();
        check_own_ship();
        check_accuracy(Signal::horizontal_accuracy, design_.degradation.horizontal_accuracy_m,
                       RecordFlag::horizontal_accuracy_above_limit);
        check_accuracy(Signal::vertical_accuracy, design_.degradation.vertical_accuracy_m,
                       RecordFlag::vertical_accuracy_above_limit);
        decide_terrain();
        decide_flight_path();
        add_notices();
        return out_;
    }

private:
    [[nodiscard]] SignalState state_of(Signal signal) const { return state_.state_of(signal, now_); }
    [[nodiscard]] bool valid(Signal signal) const { return state_of(signal) == SignalState::valid; }
    [[nodiscard]] bool turns_view(Signal heading) const {
        return valid(heading) && (heading != Signal::magnetic_heading || valid(Signal::magnetic_variation));
    }
    [[nodiscard]] static bool aims_view(SignalGroup group) {
        return group == SignalGroup::pitch || group == SignalGroup::roll || group == SignalGroup::view_heading;
    }
    /// An altitude on a known setting places the terrain well enough to show it, not to colour it.
    [[nodiscard]] bool height_is_on_qnh() const {
        return state_.own_ship.height_is_on_qnh && valid(Signal::baro_altitude) && valid(Signal::baro_setting);
    }
    /// The first source in this state; count_ for none.
    [[nodiscard]] Signal first_in(SignalGroup group, SignalState wanted) const {
        const SourceChain& chain = source_chain(group);
        for (std::size_t i = 0; i < chain.count; ++i)
            if (state_of(chain.sources[i]) == wanted) return chain.sources[i];
        return Signal::count_;
    }
    [[nodiscard]] bool has_valid(SignalGroup group) const {
        if (group != SignalGroup::view_heading) return first_in(group, SignalState::valid) != Signal::count_;
        return turns_view(Signal::true_heading) || turns_view(Signal::magnetic_heading) || turns_view(Signal::true_track);
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
        const bool served = has_valid(group);
        for (const SignalRule& rule : signal_rules()) {
            if (rule.group != group) continue;
            const SignalState state = state_of(rule.signal);
            std::uint8_t bits = consequences(rule, state);
            if (state_.is_posed && state == SignalState::missing && (bits & kRemoveTerrain) == 0) bits = kNoConsequence;
            if (group == SignalGroup::geometric_height && height_is_on_qnh()) bits &= ~kDegradeTerrain;
            if (conditions_.is_map && aims_view(group)) bits &= ~kRemoveTerrain;
            if (!served) gathered_[static_cast<std::size_t>(group)] |= bits;
            if ((bits & kFlag) != 0 && (!served || state != SignalState::missing)) flag(rule.signal, state);
        }
        all_gathered_ |= gathered_[static_cast<std::size_t>(group)];
    }
    [[nodiscard]] std::uint8_t gathered(SignalGroup group) const { return gathered_[static_cast<std::size_t>(group)]; }

    [[nodiscard]] ElementDecision decision(SignalGroup group) const {
        const SourceChain& chain = source_chain(group);
        const Signal source = first_in(group, SignalState::valid);
        for (std::size_t i = 0; i < chain.count; ++i)
            if (chain.sources[i] == source) return {i < chain.equals ? ElementShow::normal : ElementShow::substituted, source};
        const Signal stale = first_in(group, SignalState::stale);
        if (stale != Signal::count_) return {ElementShow::flagged, stale};
        return {(gathered(group) & kFailElement) != 0 ? ElementShow::failed : ElementShow::absent, Signal::count_};
    }
    void decide_element(Element element, SignalGroup group) { out_[element] = decision(group); }

    void decide_attitude() {
        const ElementDecision pitch = decision(SignalGroup::pitch), roll = decision(SignalGroup::roll);
        out_[Element::attitude] = pitch.show == ElementShow::failed ? pitch : roll.show == ElementShow::normal ? pitch : roll;
        if (out_[Element::attitude].show == ElementShow::failed) return;
        const double pitch_rad = state_[Signal::pitch].value_or(0), roll_rad = state_[Signal::roll].value_or(0);
        const design::UnusualAttitudeLimits& limits = design_.unusual_attitude;
        // The recovery picture is of the attitude, which the map does not show.
        out_.unusual_attitude = !conditions_.is_map && (pitch_rad > limits.pitch_up_rad || pitch_rad < -limits.pitch_down_rad ||
                                                        std::fabs(roll_rad) > limits.roll_rad);
        if (out_.unusual_attitude) flag(RecordFlag::attitude_unusual);
    }

    /// Only of the airspeed that is shown.
    void decide_airspeed_trend() {
        const ElementDecision& airspeed = out_[Element::airspeed];
        const bool fits = airspeed.show == ElementShow::normal && valid(Signal::airspeed_rate);
        out_[Element::airspeed_trend] = {fits ? ElementShow::normal : ElementShow::absent,
                                         fits ? Signal::airspeed_rate : Signal::count_};
    }

    /// As good as the worse of two signals that state nothing without each other; what failed is said in any case.
    [[nodiscard]] ElementDecision worse_of(SignalGroup a, SignalGroup b) const {
        const ElementDecision first = decision(a), second = decision(b);
        if (first.show == ElementShow::failed) return first;
        if (second.show == ElementShow::failed) return second;
        return first.show < second.show ? second : first;
    }
    void decide_wind() { out_[Element::wind] = worse_of(SignalGroup::wind_speed, SignalGroup::wind_direction); }

    /// A bus that does not state the source has at most one receiver: the first.
    [[nodiscard]] NavigationSource navigation_source() const {
        const base::Stamped<double>& stated = state_[Signal::navigation_source];
        if (!stated.received()) return NavigationSource::radio1;
        const double code = stated.value_or(0);
        if (!(code >= 0 && code <= flight::kMaxNavigationSource)) return NavigationSource::none;
        return static_cast<NavigationSource>(static_cast<std::uint8_t>(code));
    }

    /// Of the groups of guidance only those of the navigation source count: a receiver that is not used may be silent.
    [[nodiscard]] bool counts(SignalGroup group) const {
        const NavigationSource source = navigation_source();
        switch (group) {
            case SignalGroup::radio1_lateral:
            case SignalGroup::radio1_vertical: return source == NavigationSource::radio1;
            case SignalGroup::radio2_lateral:
            case SignalGroup::radio2_vertical: return source == NavigationSource::radio2;
            case SignalGroup::radio_course: return source == NavigationSource::radio1 || source == NavigationSource::radio2;
            case SignalGroup::gnss_lateral:
            case SignalGroup::gnss_vertical:
            case SignalGroup::gnss_course: return source == NavigationSource::gnss;
            default: return true;
        }
    }

    void decide_guidance() {
        decide_element(Element::slip, SignalGroup::slip);
        decide_element(Element::turn_rate, SignalGroup::turn_rate);
        decide_element(Element::flaps, SignalGroup::flaps);
        decide_element(Element::waypoint_bearing, SignalGroup::waypoint_bearing);
        decide_path_reference();
        out_[Element::flight_director] = worse_of(SignalGroup::director_pitch, SignalGroup::director_roll);
        decide_element(Element::selected_altitude, SignalGroup::selected_altitude);
        decide_element(Element::selected_heading, SignalGroup::selected_heading);
        decide_element(Element::selected_airspeed, SignalGroup::selected_airspeed);
        decide_element(Element::selected_vertical_speed, SignalGroup::selected_vertical_speed);
        decide_element(Element::navigation_source, SignalGroup::navigation_source);
        out_.navigation_source = navigation_source();
        switch (out_.navigation_source) {
            case NavigationSource::none: break;
            case NavigationSource::radio1:
                decide_deviations(SignalGroup::radio_course, SignalGroup::radio1_lateral, SignalGroup::radio1_vertical);
                return;
            case NavigationSource::radio2:
                decide_deviations(SignalGroup::radio_course, SignalGroup::radio2_lateral, SignalGroup::radio2_vertical);
                return;
            case NavigationSource::gnss:
                decide_deviations(SignalGroup::gnss_course, SignalGroup::gnss_lateral, SignalGroup::gnss_vertical);
                return;
        }
        for (const Element element : {Element::course, Element::lateral_deviation, Element::vertical_deviation})
            out_[element].show =
                out_[Element::navigation_source].show == ElementShow::failed ? ElementShow::failed : ElementShow::absent;
    }

    /// A glide path is flown on approaches only; an unknown phase may be one.
    void decide_path_reference() {
        decide_element(Element::flight_path_reference, SignalGroup::selected_glidepath);
        const flight::Scenario scenario = conditions_.phase.phase.scenario;
        if (scenario != flight::Scenario::approach && scenario != flight::Scenario::unknown)
            out_[Element::flight_path_reference] = {ElementShow::absent, Signal::count_};
    }

    /// A deviation is as good as the statement which receiver it comes from.
    void decide_deviations(SignalGroup course, SignalGroup lateral, SignalGroup vertical) {
        decide_element(Element::course, course);
        decide_element(Element::lateral_deviation, lateral);
        decide_element(Element::vertical_deviation, vertical);
        const ElementShow source = out_[Element::navigation_source].show;
        if (source != ElementShow::flagged && source != ElementShow::failed) return;
        for (const Element element : {Element::course, Element::lateral_deviation, Element::vertical_deviation}) {
            ElementDecision& decided = out_[element];
            if (decided.show == ElementShow::absent || decided.show >= source) continue;
            decided.show = source;
            if (source == ElementShow::failed) decided.source = Signal::count_;
        }
    }

    void decide_on_ground() {
        constexpr double kOnGround_m = 5;
        const ElementDecision& ground = out_[Element::ground_height];
        out_.is_on_ground = ground.show == ElementShow::normal && state_[ground.source].value_or(0) < kOnGround_m;
    }

    /// A minimum in the ground below the own ship is wrong, wherever it is near enough to matter.
    void decide_minimums() {
        constexpr double kNear_m = 100;
        decide_element(Element::radio_minimum, SignalGroup::radio_minimum);
        decide_element(Element::baro_minimum, SignalGroup::baro_minimum);
        ElementDecision& minimum = out_[Element::baro_minimum];
        const ElementDecision& ground = out_[Element::ground_height];
        if (!may_approach()) return;
        const bool knows_ground = ground.show == ElementShow::normal && valid(Signal::baro_altitude);
        const double altitude_m = state_[Signal::baro_altitude].value_or(0);
        const double height_m = knows_ground ? state_[ground.source].value_or(0) : 0;
        if (minimum.source != Signal::count_ && knows_ground && height_m < kNear_m &&
            state_[minimum.source].value_or(0) < altitude_m - height_m) {
            minimum = {ElementShow::failed, Signal::count_};
            flag(RecordFlag::minimum_below_ground);
        }
        if (out_[Element::radio_minimum].show == ElementShow::normal && valid(Signal::radio_height))
            out_.radio_minimum = minimum_state(Signal::radio_height, Signal::decision_height);
        if (minimum.show == ElementShow::normal && valid(Signal::baro_altitude))
            out_.baro_minimum = minimum_state(Signal::baro_altitude, Signal::minimum_altitude);
    }

    /// In the air, and on an approach or in a descent of an unknown phase: before take-off every aircraft is below its minimum.
    [[nodiscard]] bool may_approach() const {
        if (out_.is_on_ground) return false;
        const flight::Scenario scenario = conditions_.phase.phase.scenario;
        const bool descends = valid(Signal::vertical_speed) && state_[Signal::vertical_speed].value_or(0) < 0;
        return scenario == flight::Scenario::approach || (scenario == flight::Scenario::unknown && descends);
    }

    [[nodiscard]] MinimumsState minimum_state(Signal height, Signal minimum) const {
        const double above_m = state_[height].value_or(0) - state_[minimum].value_or(0);
        if (above_m > kNearMinimum_m) return MinimumsState::above;
        return above_m > 0 ? MinimumsState::near : MinimumsState::at_or_below;
    }

    void decide_heading() {
        decide_element(Element::heading, SignalGroup::view_heading);
        for (Signal heading : {Signal::true_heading, Signal::magnetic_heading, Signal::true_track})
            if (out_.view_heading == Signal::count_ && turns_view(heading)) out_.view_heading = heading;
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
        if (out_.terrain_ahead != TerrainAhead::none) flag(RecordFlag::terrain_ahead);
        if (out_.terrain_degraded) flag(RecordFlag::terrain_degraded);
        ElementDecision& ground = out_[Element::ground_height];
        if (out_.terrain_degraded && ground.source == Signal::height_above_terrain) ground.show = ElementShow::substituted;
        if (conditions_.terrain == TerrainSource::none) flag(RecordFlag::terrain_missing);
        if (conditions_.terrain == TerrainSource::outside) flag(RecordFlag::terrain_outside_database);
        if (conditions_.terrain == TerrainSource::failed) flag(RecordFlag::terrain_failed);
        if (conditions_.terrain == TerrainSource::over_budget) flag(RecordFlag::terrain_over_budget);
        if (conditions_.terrain == TerrainSource::too_coarse) flag(RecordFlag::terrain_too_coarse);
        if (conditions_.terrain == TerrainSource::above_own_ship) flag(RecordFlag::terrain_above_own_ship);
        if (out_.show_terrain && conditions_.terrain_is_coarse) flag(RecordFlag::terrain_coarse);
        if (out_.show_terrain && conditions_.image_is_missing) flag(RecordFlag::terrain_no_image);
        if (is_flat()) flag(RecordFlag::terrain_flat);
        if (state_.traffic.is_cut) flag(RecordFlag::traffic_cut);
        if (out_.show_terrain && conditions_.data_are_out_of_date) flag(RecordFlag::data_out_of_date);
    }

    /// Heights of the database are known whatever is shown of it; the own ship's place and height must be trustworthy.
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
        notice_if(out_.terrain_ahead == TerrainAhead::caution, NoticeId::terrain_ahead_caution);
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
        notice_if(out_.show_terrain && conditions_.data_are_out_of_date, NoticeId::data_out_of_date);
        notice_if(shows_measure(), NoticeId::analysis_overlay);
        notice_if(state_.traffic.is_cut, NoticeId::traffic_incomplete);
        add_information();
    }

    void add_position_notices() {
        const SignalState position = state_.own_ship.state;
        const bool has_position =
            position == SignalState::valid && has_valid(SignalGroup::latitude) && has_valid(SignalGroup::longitude);
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
        notice_if(out_.show_terrain && conditions_.image_is_missing, NoticeId::no_terrain_image);
        notice_if(conditions_.is_map && design_.view.mode == design::ViewMode::orthographic, NoticeId::orthographic_view);
        notice_if(is_flat(), NoticeId::flat_ground);
        notice_if(conditions_.is_reduced, NoticeId::graphics_reduced);
        notice_if(conditions_.generated_flight, NoticeId::generated_flight);
        notice_if(true, NoticeId::not_for_navigation);
    }

    const flight::AircraftState& state_;
    base::Time now_;
    const DisplayConditions& conditions_;
    const design::DesignSettings& design_;
    std::array<std::uint8_t, kGroupCount> gathered_{};
    std::uint8_t all_gathered_ = 0;
    DisplayDecisions out_;
};

}  // namespace

DisplayDecisions decide_display(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
                                const design::DesignSettings& design) noexcept {
    return Policy(state, now, conditions, design).decide();
}

}  // namespace tedavis::policy
