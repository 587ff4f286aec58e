#include "render_core/policy/failure_policy.hpp"

#include <cmath>

namespace tedavis::policy {
namespace {

using base::SignalState;
using flight::NavigationSource;
using flight::Signal;

constexpr double kSlowestFlightPath_mps = 10;  // below, the direction of motion on the ground is noise

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
        decide_wind();
        decide_element(Element::outside_temperature, SignalGroup::outside_temperature);
        decide_guidance();
        decide_minimums();
        check_own_ship();
        check_accuracy(Signal::horizontal_accuracy, design_.degradation.horizontal_accuracy_m);
        check_accuracy(Signal::vertical_accuracy, design_.degradation.vertical_accuracy_m);
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

    void flag(std::string_view name, std::string_view what) {
        base::FixedString<47> text(name);
        text.append(".");
        text.append(what);
        const bool added = out_.flags.try_push_back(text);
        TEDAVIS_CHECK(added);
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
            if ((bits & kFlag) != 0 && (!served || state != SignalState::missing)) flag(to_string(rule.signal), to_string(state));
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
        if (out_.unusual_attitude) flag("attitude", "unusual");
    }

    /// Only of the airspeed that is shown.
    void decide_airspeed_trend() {
        const ElementDecision& airspeed = out_[Element::airspeed];
        const bool fits = airspeed.show == ElementShow::normal && valid(Signal::airspeed_rate);
        out_[Element::airspeed_trend] = {fits ? ElementShow::normal : ElementShow::absent,
                                         fits ? Signal::airspeed_rate : Signal::count_};
    }

    /// As good as the worse of two signals that state nothing without each other.
    [[nodiscard]] ElementDecision worse_of(SignalGroup a, SignalGroup b) const {
        const ElementDecision first = decision(a), second = decision(b);
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

    /// A minimum in the ground below the own ship is wrong, wherever it is near enough to matter.
    void decide_minimums() {
        constexpr double kNear_m = 100;
        decide_element(Element::radio_minimum, SignalGroup::radio_minimum);
        decide_element(Element::baro_minimum, SignalGroup::baro_minimum);
        ElementDecision& minimum = out_[Element::baro_minimum];
        const ElementDecision ground = decision(SignalGroup::ground_height);
        const bool knows_ground = ground.show == ElementShow::normal && valid(Signal::baro_altitude);
        const double height_m = knows_ground ? state_[ground.source].value_or(0) : 0;
        const double ground_msl_m = state_[Signal::baro_altitude].value_or(0) - height_m;
        if (minimum.source != Signal::count_ && knows_ground && height_m < kNear_m &&
            state_[minimum.source].value_or(0) < ground_msl_m) {
            minimum = {ElementShow::failed, Signal::count_};
            flag(to_string(Signal::minimum_altitude), "below_ground");
        }
        out_.minimums = minimums_state(ground);
    }

    /// Only on an approach and in the air: before take-off every aircraft is below its minimum.
    [[nodiscard]] MinimumsState minimums_state(const ElementDecision& ground) const {
        constexpr double kOnGround_m = 5;
        if (conditions_.phase.phase.scenario != flight::Scenario::approach) return MinimumsState::none;
        if (ground.show == ElementShow::normal && state_[ground.source].value_or(0) < kOnGround_m) return MinimumsState::none;
        double above_m = 0;
        if (out_[Element::radio_minimum].show == ElementShow::normal && ground.show == ElementShow::normal)
            above_m = state_[ground.source].value_or(0) - state_[Signal::decision_height].value_or(0);
        else if (out_[Element::baro_minimum].show == ElementShow::normal && valid(Signal::baro_altitude))
            above_m = state_[Signal::baro_altitude].value_or(0) - state_[Signal::minimum_altitude].value_or(0);
        else
            return MinimumsState::none;
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
        if (conditions_.is_map) flag("map", up.source == Signal::count_ ? "north_up" : "heading_up");
    }

    void check_own_ship() {
        const SignalState state = state_.own_ship.state;
        if (state != SignalState::valid) {
            all_gathered_ |= kRemoveTerrain;
            flag("own_ship", to_string(state));
        } else if (!state_.own_ship.height_is_geometric) {
            all_gathered_ |= kRemoveWarningColors;
            if (!height_is_on_qnh()) all_gathered_ |= kDegradeTerrain;
            flag("own_ship", height_is_on_qnh() ? "height_on_qnh" : "height_not_geometric");
        }
    }

    void check_accuracy(Signal accuracy, double limit_m) {
        if (!valid(accuracy) || state_[accuracy].value_or(0) <= limit_m) return;
        all_gathered_ |= kRemoveWarningColors | kDegradeTerrain;
        flag(to_string(accuracy), "above_limit");
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
        if (out_.terrain_ahead != TerrainAhead::none) flag("terrain", "ahead");
        if (out_.terrain_degraded) flag("terrain", "degraded");
        ElementDecision& ground = out_[Element::ground_height];
        if (out_.terrain_degraded && ground.source == Signal::height_above_terrain) ground.show = ElementShow::substituted;
        if (conditions_.terrain == TerrainSource::none) flag("terrain", "missing");
        if (conditions_.terrain == TerrainSource::outside) flag("terrain", "outside_database");
        if (conditions_.terrain == TerrainSource::failed) flag("terrain", "failed");
        if (conditions_.terrain == TerrainSource::over_budget) flag("terrain", "over_budget");
        if (conditions_.terrain == TerrainSource::too_coarse) flag("terrain", "too_coarse");
        if (conditions_.terrain == TerrainSource::above_own_ship) flag("terrain", "above_own_ship");
        if (out_.show_terrain && conditions_.terrain_is_coarse) flag("terrain", "coarse");
        if (out_.show_terrain && conditions_.image_is_missing) flag("terrain", "no_image");
        if (is_flat()) flag("terrain", "flat");
        if (state_.traffic.is_cut) flag("traffic", "cut");
        if (out_.show_terrain && conditions_.data_are_out_of_date) flag("data", "out_of_date");
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

    void notice(NoticeLevel level, std::string_view text) {
        const bool added = out_.notices.try_push_back({level, text});
        TEDAVIS_CHECK(added);
    }

    void add_notices() {
        if (conditions_.terrain == TerrainSource::failed) notice(NoticeLevel::warning, "TERRAIN FAIL");
        if (out_.below_terrain) notice(NoticeLevel::warning, "BELOW TERRAIN");
        if (out_.terrain_ahead != TerrainAhead::none)
            notice(out_.terrain_ahead == TerrainAhead::warning ? NoticeLevel::warning : NoticeLevel::caution, "TERRAIN AHEAD");
        const SignalState position = state_.own_ship.state;
        if (position == SignalState::stale)
            notice(NoticeLevel::caution, "GPS POSITION STALE");
        else if (position != SignalState::valid || !has_valid(SignalGroup::latitude) || !has_valid(SignalGroup::longitude))
            notice(NoticeLevel::caution, "NO GPS POSITION");
        if (conditions_.terrain == TerrainSource::none) notice(NoticeLevel::caution, "NO TERRAIN DATA");
        if (conditions_.terrain == TerrainSource::outside) notice(NoticeLevel::caution, "OUTSIDE DATABASE");
        if (conditions_.terrain == TerrainSource::above_own_ship && !out_.below_terrain)
            notice(NoticeLevel::caution, "BELOW TERRAIN");
        if (out_.terrain_degraded) notice(NoticeLevel::caution, "TERRAIN DEGRADED");
        if (out_.show_terrain && conditions_.terrain_is_coarse) notice(NoticeLevel::caution, "TERRAIN COARSE");
        const TerrainSource source = conditions_.terrain;
        const bool removed_by_signal = source == TerrainSource::ready && !out_.show_terrain;
        if (removed_by_signal || source == TerrainSource::over_budget || source == TerrainSource::too_coarse)
            notice(NoticeLevel::caution, "TERRAIN OFF");
        if (conditions_.is_map && out_[Element::map_up].show == ElementShow::flagged)
            notice(NoticeLevel::caution, "MAP NORTH UP");
        if (out_.minimums == MinimumsState::at_or_below) notice(NoticeLevel::caution, "MINIMUMS");
        add_phase_notices();
        if (out_.show_terrain && conditions_.data_are_out_of_date) notice(NoticeLevel::caution, "DATA OUT OF DATE");
        if (shows_measure()) notice(NoticeLevel::caution, "ANALYSIS OVERLAY");
        if (state_.traffic.is_cut) notice(NoticeLevel::caution, "TRAFFIC INCOMPLETE");
        if (out_.show_terrain && conditions_.image_is_missing) notice(NoticeLevel::information, "NO TERRAIN IMAGE");
        if (conditions_.is_map && design_.view.mode == design::ViewMode::orthographic)
            notice(NoticeLevel::information, "ORTHOGRAPHIC VIEW");
        if (is_flat()) notice(NoticeLevel::information, "FLAT - NO RELIEF");
        if (conditions_.is_reduced) notice(NoticeLevel::information, "GRAPHICS REDUCED");
        if (conditions_.generated_flight) notice(NoticeLevel::information, "GENERATED FLIGHT");
        notice(NoticeLevel::information, "NOT FOR NAVIGATION");
    }

    /// Nothing lies over the recovery picture.
    [[nodiscard]] bool shows_measure() const { return conditions_.shows_measure && out_.show_terrain && !out_.unusual_attitude; }

    void add_phase_notices() {
        if (conditions_.phase.switch_fault) {
            flag("phase", "switch_fault");
            notice(NoticeLevel::caution, "PHASE SWITCH FAULT");
        }
        if (conditions_.phase.disagreement) {
            flag("phase", "disagreement");
            notice(NoticeLevel::caution, "PHASE DISAGREE");
        }
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
