#include "render_core/policy/signal_rules.hpp"

#include "render_core/base/check.hpp"

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
    {Signal::lateral_acceleration, SignalGroup::slip, kNoConsequence, kFlag, kFailed, kFailed},
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
    {Signal::heading_rate, SignalGroup::turn_rate, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::flaps_lever, SignalGroup::flaps, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::flaps_position, SignalGroup::flaps, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::navigation_source, SignalGroup::navigation_source, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::ils1_localizer_deviation, SignalGroup::radio1_lateral, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::ils1_glideslope_deviation, SignalGroup::radio1_vertical, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::ils2_localizer_deviation, SignalGroup::radio2_lateral, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::ils2_glideslope_deviation, SignalGroup::radio2_vertical, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::cross_track_deviation, SignalGroup::gnss_lateral, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::gnss_vertical_deviation, SignalGroup::gnss_vertical, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::desired_track, SignalGroup::gnss_course, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::waypoint_bearing, SignalGroup::waypoint_bearing, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_course, SignalGroup::radio_course, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_glidepath, SignalGroup::selected_glidepath, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::flight_director_pitch, SignalGroup::director_pitch, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::flight_director_roll, SignalGroup::director_roll, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_altitude, SignalGroup::selected_altitude, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_heading, SignalGroup::selected_heading, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_airspeed, SignalGroup::selected_airspeed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::selected_vertical_speed, SignalGroup::selected_vertical_speed, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::decision_height, SignalGroup::radio_minimum, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::minimum_altitude, SignalGroup::baro_minimum, kNoConsequence, kFlag, kFailed, kFailed},
    {Signal::airspeed_rate, SignalGroup::not_shown, 0, 0, 0, 0},
    {Signal::height_above_terrain, SignalGroup::ground_height, kNoConsequence, kFlag, kFailed, kFailed},
};
static_assert(sizeof kRules / sizeof kRules[0] == flight::kSignalCount);
constexpr bool rules_in_order() {
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        if (kRules[i].signal != static_cast<Signal>(i)) return false;
    return true;
}
static_assert(rules_in_order());

/// In the order of the groups.
constexpr SourceChain kChains[] = {
    {SignalGroup::latitude, 1, 1, {Signal::latitude}},
    {SignalGroup::longitude, 1, 1, {Signal::longitude}},
    {SignalGroup::geometric_height, 2, 2, {Signal::ellipsoid_height, Signal::true_altitude}},
    {SignalGroup::pitch, 1, 1, {Signal::pitch}},
    {SignalGroup::roll, 1, 1, {Signal::roll}},
    {SignalGroup::view_heading, 3, 2, {Signal::true_heading, Signal::magnetic_heading, Signal::true_track}},
    {SignalGroup::altitude,
     4,
     1,
     {Signal::baro_altitude, Signal::true_altitude, Signal::ellipsoid_height, Signal::standard_altitude}},
    {SignalGroup::airspeed,
     4,
     2,
     {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed, Signal::ground_speed}},
    {SignalGroup::vertical_speed, 1, 1, {Signal::vertical_speed}},
    {SignalGroup::baro_setting, 1, 1, {Signal::baro_setting}},
    {SignalGroup::ground_height, 2, 2, {Signal::radio_height, Signal::height_above_terrain}},
    {SignalGroup::horizontal_accuracy, 1, 1, {Signal::horizontal_accuracy}},
    {SignalGroup::vertical_accuracy, 1, 1, {Signal::vertical_accuracy}},
    {SignalGroup::wind_speed, 1, 1, {Signal::wind_speed}},
    {SignalGroup::wind_direction, 1, 1, {Signal::wind_direction}},
    {SignalGroup::outside_temperature, 1, 1, {Signal::outside_temperature}},
    {SignalGroup::slip, 1, 1, {Signal::lateral_acceleration}},
    {SignalGroup::turn_rate, 1, 1, {Signal::heading_rate}},
    {SignalGroup::flaps, 2, 1, {Signal::flaps_position, Signal::flaps_lever}},
    {SignalGroup::navigation_source, 1, 1, {Signal::navigation_source}},
    {SignalGroup::radio1_lateral, 1, 1, {Signal::ils1_localizer_deviation}},
    {SignalGroup::radio1_vertical, 1, 1, {Signal::ils1_glideslope_deviation}},
    {SignalGroup::radio2_lateral, 1, 1, {Signal::ils2_localizer_deviation}},
    {SignalGroup::radio2_vertical, 1, 1, {Signal::ils2_glideslope_deviation}},
    {SignalGroup::gnss_lateral, 1, 1, {Signal::cross_track_deviation}},
    {SignalGroup::gnss_vertical, 1, 1, {Signal::gnss_vertical_deviation}},
    {SignalGroup::radio_course, 1, 1, {Signal::selected_course}},
    {SignalGroup::gnss_course, 1, 1, {Signal::desired_track}},
    {SignalGroup::waypoint_bearing, 1, 1, {Signal::waypoint_bearing}},
    {SignalGroup::selected_glidepath, 1, 1, {Signal::selected_glidepath}},
    {SignalGroup::director_pitch, 1, 1, {Signal::flight_director_pitch}},
    {SignalGroup::director_roll, 1, 1, {Signal::flight_director_roll}},
    {SignalGroup::selected_altitude, 1, 1, {Signal::selected_altitude}},
    {SignalGroup::selected_heading, 1, 1, {Signal::selected_heading}},
    {SignalGroup::selected_airspeed, 1, 1, {Signal::selected_airspeed}},
    {SignalGroup::selected_vertical_speed, 1, 1, {Signal::selected_vertical_speed}},
    {SignalGroup::radio_minimum, 1, 1, {Signal::decision_height}},
    {SignalGroup::baro_minimum, 1, 1, {Signal::minimum_altitude}},
};
static_assert(sizeof kChains / sizeof kChains[0] == kGroupCount);
constexpr bool chains_in_order() {
    for (std::size_t i = 0; i < kGroupCount; ++i)
        if (kChains[i].group != static_cast<SignalGroup>(i)) return false;
    return true;
}
static_assert(chains_in_order());

}  // namespace

base::Span<const SignalRule> signal_rules() noexcept { return base::Span<const SignalRule>(kRules); }

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

const SourceChain& source_chain(SignalGroup group) noexcept {
    const auto index = static_cast<std::size_t>(group);
    TEDAVIS_CHECK(index < kGroupCount);
    return kChains[index];
}

}  // namespace tedavis::policy
