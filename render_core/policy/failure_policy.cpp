#include "render_core/policy/failure_policy.hpp"

#include <cmath>

namespace tedavis::policy {
namespace {

using base::SignalState;
using flight::Signal;

constexpr std::uint8_t kNoTerrain = kRemoveTerrain | kFlag;
constexpr std::uint8_t kNoTerrainFailed = kRemoveTerrain | kFailElement | kFlag;
constexpr std::uint8_t kUncertain = kRemoveWarningColors | kDegradeTerrain | kFlag;
constexpr std::uint8_t kFailed = kFailElement | kFlag;

/// In the order of the signals: missing, stale, lost, invalid.
constexpr SignalRule kRules[] = {
    {Signal::latitude, SignalGroup::latitude, kNoTerrain, kNoTerrain, kNoTerrain, kNoTerrain},
    {Signal::longitude, SignalGroup::longitude, kNoTerrain, kNoTerrain, kNoTerrain, kNoTerrain},
    {Signal::ellipsoid_height, SignalGroup::geometric_height, kUncertain, kUncertain, kUncertain, kUncertain},
    {Signal::ground_speed, SignalGroup::airspeed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::true_track, SignalGroup::view_heading, kNoConsequence, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::horizontal_accuracy, SignalGroup::horizontal_accuracy, kNoConsequence, kUncertain, kUncertain, kUncertain},
    {Signal::vertical_accuracy, SignalGroup::vertical_accuracy, kNoConsequence, kUncertain, kUncertain, kUncertain},
    {Signal::pitch, SignalGroup::pitch, kNoTerrainFailed, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::roll, SignalGroup::roll, kNoTerrainFailed, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::true_heading, SignalGroup::view_heading, kNoTerrainFailed, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::magnetic_heading, SignalGroup::view_heading, kNoConsequence, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::magnetic_variation, SignalGroup::view_heading, kNoConsequence, kNoTerrain, kNoTerrain, kNoTerrain},
    {Signal::sideslip, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::pitch_rate, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::roll_rate, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::yaw_rate, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::longitudinal_acceleration, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::lateral_acceleration, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::normal_acceleration, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::indicated_airspeed, SignalGroup::airspeed, kFailed, kFlag, kFailed, kFailed},
    {Signal::true_airspeed, SignalGroup::airspeed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::calibrated_airspeed, SignalGroup::airspeed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::standard_altitude, SignalGroup::altitude, kNoConsequence, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::baro_altitude, SignalGroup::altitude, kNoTerrainFailed, kNoTerrain, kNoTerrainFailed, kNoTerrainFailed},
    {Signal::baro_setting, SignalGroup::baro_setting, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::vertical_speed, SignalGroup::vertical_speed, kFailed, kFlag, kFailed, kFailed},
    {Signal::radio_height, SignalGroup::ground_height, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::wind_speed, SignalGroup::wind_speed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::wind_direction, SignalGroup::wind_direction, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::outside_temperature, SignalGroup::outside_temperature, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::true_altitude, SignalGroup::geometric_height, kNoConsequence, kUncertain, kUncertain, kUncertain},
    {Signal::height_above_terrain, SignalGroup::ground_height, kNoConsequence, kFlag, kFailed, kFailed},
};
static_assert(sizeof kRules / sizeof kRules[0] == flight::kSignalCount);
constexpr bool in_order() {
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        if (kRules[i].signal != static_cast<Signal>(i)) return false;
    return true;
}
static_assert(in_order());

/// Where a piece of information may come from, the first choice first. `equals` of them are as good as the first.
struct SourceChain {
    SignalGroup group;
    std::uint8_t count, equals;
    Signal sources[4];
};
constexpr SourceChain kLatitude{SignalGroup::latitude, 1, 1, {Signal::latitude}};
constexpr SourceChain kLongitude{SignalGroup::longitude, 1, 1, {Signal::longitude}};
constexpr SourceChain kGeometricHeight{SignalGroup::geometric_height, 2, 2, {Signal::ellipsoid_height, Signal::true_altitude}};
constexpr SourceChain kPitch{SignalGroup::pitch, 1, 1, {Signal::pitch}};
constexpr SourceChain kRoll{SignalGroup::roll, 1, 1, {Signal::roll}};
constexpr SourceChain kHeading{
    SignalGroup::view_heading, 3, 2, {Signal::true_heading, Signal::magnetic_heading, Signal::true_track}};
constexpr SourceChain kAltitude{
    SignalGroup::altitude,
    4,
    1,
    {Signal::baro_altitude, Signal::true_altitude, Signal::ellipsoid_height, Signal::standard_altitude}};
constexpr SourceChain kAirspeed{
    SignalGroup::airspeed,
    4,
    2,
    {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed, Signal::ground_speed}};
constexpr SourceChain kVerticalSpeed{SignalGroup::vertical_speed, 1, 1, {Signal::vertical_speed}};
constexpr SourceChain kBaroSetting{SignalGroup::baro_setting, 1, 1, {Signal::baro_setting}};
constexpr SourceChain kGroundHeight{SignalGroup::ground_height, 2, 2, {Signal::radio_height, Signal::height_above_terrain}};
constexpr SourceChain kHorizontalAccuracy{SignalGroup::horizontal_accuracy, 1, 1, {Signal::horizontal_accuracy}};
constexpr SourceChain kVerticalAccuracy{SignalGroup::vertical_accuracy, 1, 1, {Signal::vertical_accuracy}};
constexpr SourceChain kWindSpeed{SignalGroup::wind_speed, 1, 1, {Signal::wind_speed}};
constexpr SourceChain kWindDirection{SignalGroup::wind_direction, 1, 1, {Signal::wind_direction}};
constexpr SourceChain kTemperature{SignalGroup::outside_temperature, 1, 1, {Signal::outside_temperature}};
constexpr const SourceChain* kChains[] = {
    &kLatitude,         &kLongitude, &kGeometricHeight, &kPitch,       &kRoll,         &kHeading,
    &kAltitude,         &kAirspeed,  &kVerticalSpeed,   &kBaroSetting, &kGroundHeight, &kHorizontalAccuracy,
    &kVerticalAccuracy, &kWindSpeed, &kWindDirection,   &kTemperature};

constexpr double kSlowestFlightPath_mps = 10;  // below, the direction of motion on the ground is noise

/// The states of one frame, and the decisions as they are made.
class Policy {
public:
    Policy(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
           const design::DesignSettings& design)
        : state_(state), now_(now), conditions_(conditions), design_(design) {}

    DisplayDecisions decide() {
        for (const SourceChain* chain : kChains) apply(*chain);
        decide_attitude();
        decide_heading();
        decide_map();
        decide_element(Element::airspeed, kAirspeed);
        decide_element(Element::altitude, kAltitude);
        decide_element(Element::vertical_speed, kVerticalSpeed);
        decide_element(Element::baro_setting, kBaroSetting);
        decide_element(Element::ground_height, kGroundHeight);
        decide_wind();
        decide_element(Element::outside_temperature, kTemperature);
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
    [[nodiscard]] Signal first_in(const SourceChain& chain, SignalState wanted) const {
        for (std::size_t i = 0; i < chain.count; ++i)
            if (state_of(chain.sources[i]) == wanted) return chain.sources[i];
        return Signal::count_;
    }
    [[nodiscard]] bool has_valid(const SourceChain& chain) const {
        if (chain.group != SignalGroup::view_heading) return first_in(chain, SignalState::valid) != Signal::count_;
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
    void apply(const SourceChain& chain) {
        const bool served = has_valid(chain);
        for (const SignalRule& rule : kRules) {
            if (rule.group != chain.group) continue;
            const SignalState state = state_of(rule.signal);
            std::uint8_t bits = consequences(rule, state);
            if (state_.is_posed && state == SignalState::missing && (bits & kRemoveTerrain) == 0) bits = kNoConsequence;
            if (chain.group == SignalGroup::geometric_height && height_is_on_qnh()) bits &= ~kDegradeTerrain;
            if (conditions_.is_map && aims_view(chain.group)) bits &= ~kRemoveTerrain;
            if (!served) gathered_[static_cast<std::size_t>(chain.group)] |= bits;
            if ((bits & kFlag) != 0 && (!served || state != SignalState::missing)) flag(to_string(rule.signal), to_string(state));
        }
        all_gathered_ |= gathered_[static_cast<std::size_t>(chain.group)];
    }
    [[nodiscard]] std::uint8_t gathered(SignalGroup group) const { return gathered_[static_cast<std::size_t>(group)]; }

    [[nodiscard]] ElementDecision decision(const SourceChain& chain) const {
        const Signal source = first_in(chain, SignalState::valid);
        for (std::size_t i = 0; i < chain.count; ++i)
            if (chain.sources[i] == source) return {i < chain.equals ? ElementShow::normal : ElementShow::substituted, source};
        const Signal stale = first_in(chain, SignalState::stale);
        if (stale != Signal::count_) return {ElementShow::flagged, stale};
        return {(gathered(chain.group) & kFailElement) != 0 ? ElementShow::failed : ElementShow::absent, Signal::count_};
    }
    void decide_element(Element element, const SourceChain& chain) { out_[element] = decision(chain); }

    void decide_attitude() {
        const ElementDecision pitch = decision(kPitch), roll = decision(kRoll);
        out_[Element::attitude] = pitch.show == ElementShow::failed ? pitch : roll.show == ElementShow::normal ? pitch : roll;
        if (out_[Element::attitude].show == ElementShow::failed) return;
        const double pitch_rad = state_[Signal::pitch].value_or(0), roll_rad = state_[Signal::roll].value_or(0);
        const design::UnusualAttitudeLimits& limits = design_.unusual_attitude;
        // The recovery picture is of the attitude, which the map does not show.
        out_.unusual_attitude = !conditions_.is_map && (pitch_rad > limits.pitch_up_rad || pitch_rad < -limits.pitch_down_rad ||
                                                        std::fabs(roll_rad) > limits.roll_rad);
        if (out_.unusual_attitude) flag("attitude", "unusual");
    }

    /// As good as the worse of its two signals: a speed without a direction is no wind.
    void decide_wind() {
        const ElementDecision speed = decision(kWindSpeed), direction = decision(kWindDirection);
        out_[Element::wind] = speed.show < direction.show ? direction : speed;
    }

    void decide_heading() {
        decide_element(Element::heading, kHeading);
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
        else if (position != SignalState::valid || !has_valid(kLatitude) || !has_valid(kLongitude))
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
    std::array<std::uint8_t, static_cast<std::size_t>(SignalGroup::not_shown)> gathered_{};
    std::uint8_t all_gathered_ = 0;
    DisplayDecisions out_;
};

}  // namespace

const SignalRule& signal_rule(Signal signal) noexcept {
    const auto index = static_cast<std::size_t>(signal);
    TEDAVIS_CHECK(index < flight::kSignalCount);
    return kRules[index];
}

std::uint8_t consequences(const SignalRule& rule, SignalState state) noexcept {
    switch (state) {
        case SignalState::valid: return kNoConsequence;
        case SignalState::missing: return rule.missing;
        case SignalState::stale: return rule.stale;
        case SignalState::lost: return rule.lost;
        case SignalState::invalid: return rule.invalid;
    }
    return rule.invalid;
}

DisplayDecisions decide_display(const flight::AircraftState& state, base::Time now, const DisplayConditions& conditions,
                                const design::DesignSettings& design) noexcept {
    return Policy(state, now, conditions, design).decide();
}

}  // namespace tedavis::policy
