/// Which signals state which information, in what order of preference, and what follows when they are not valid. Pure tables.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/base/stamped.hpp"
#include "render_core/flight/signal.hpp"

namespace tedavis::policy {

/// Groups of signals that state the same information, in order of preference.
enum class SignalGroup : std::uint8_t {
    latitude,
    longitude,
    geometric_height,
    pitch,
    roll,
    view_heading,
    altitude,
    airspeed,
    vertical_speed,
    baro_setting,
    ground_height,
    horizontal_accuracy,
    vertical_accuracy,
    wind_speed,
    wind_direction,
    outside_temperature,
    slip,
    turn_rate,
    flaps,
    navigation_source,
    radio1_lateral,
    radio1_vertical,
    radio2_lateral,
    radio2_vertical,
    gnss_lateral,
    gnss_vertical,
    radio_course,
    gnss_course,
    waypoint_bearing,
    selected_glidepath,
    director_pitch,
    director_roll,
    selected_altitude,
    selected_heading,
    selected_airspeed,
    selected_vertical_speed,
    radio_minimum,
    baro_minimum,
    not_shown,
};

/// Consequences when no signal of a group is valid; bits.
enum Consequence : std::uint8_t {
    kNoConsequence = 0,
    kRemoveTerrain = 1,  ///< and with it the warning colours
    kRemoveWarningColors = 2,
    kDegradeTerrain = 4,
    kFailElement = 8,  ///< red cross in its place; without this bit the last value stays with a flag
    kFlag = 16,        ///< named in the flags
};

/// A row of the table: the consequences of a signal's state while no other signal of its group is valid. While another
/// is valid, that one is shown under its own label, a signal that was received and went bad is still named in the flags,
/// and a missing one leaves no trace.
struct SignalRule {
    flight::Signal signal;
    SignalGroup group;
    std::uint8_t missing, stale, lost, invalid;
};
/// All rows, in the order of the signals.
[[nodiscard]] base::Span<const SignalRule> signal_rules() noexcept;
[[nodiscard]] const SignalRule& signal_rule(flight::Signal signal) noexcept;
[[nodiscard]] std::uint8_t consequences(const SignalRule& rule, base::SignalState state) noexcept;

/// Where a piece of information may come from, the first choice first. `equals` of them are as good as the first.
struct SourceChain {
    SignalGroup group;
    std::uint8_t count, equals;
    flight::Signal sources[4];
};
inline constexpr std::size_t kGroupCount = static_cast<std::size_t>(SignalGroup::not_shown);
/// `group` must not be not_shown.
[[nodiscard]] const SourceChain& source_chain(SignalGroup group) noexcept;

}  // namespace tedavis::policy
