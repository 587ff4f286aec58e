/// Decides what the display shows when signals are missing, stale, lost or invalid. Pure function.
///
/// The whole table is in render_core/display/README.md; signal_rule() returns a row. After AC 25-11B 6.2.1.7 a failure is shown
/// in the place of the information, and stale data are never shown as valid; terrain follows the rule of the synthetic-vision
/// manuals (Garmin 190-02177: disabled without attitude, heading, position or database).
#pragma once

#include <cstdint>

#include "render_core/base/stamped.hpp"
#include "render_core/base/time.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::policy {

/// The state of the terrain database for this frame.
enum class TerrainSource : std::uint8_t {
    none,  ///< no database was given
    ready,
    outside,         ///< the own ship is not over it
    failed,          ///< it could not be read or failed its checks
    over_budget,     ///< its coarsest meshes exceed the device's budgets
    too_coarse,      ///< the chunks in memory would show a wrong picture
    above_own_ship,  ///< the own ship would be below its surface: one of the two is wrong
};

struct DisplayConditions {
    TerrainSource terrain = TerrainSource::none;
    flight::PhaseStatus phase;
    bool generated_flight = false;      ///< the flight comes from a scenario
    bool terrain_is_coarse = false;     ///< because of budgets its error exceeds the design's limit
    bool image_is_missing = false;      ///< the design shows an image over the terrain, and there is none
    bool data_are_out_of_date = false;  ///< spatial data that the design shows are not valid at this time, and left out
    bool is_reduced = false;            ///< the picture is reduced for the frame's deadline, and the design requests a notice
    bool shows_measure = false;         ///< colours show a measure of the picture (saliency, clutter)
    TerrainAhead terrain_ahead = TerrainAhead::none;
    bool is_map = false;  ///< the picture is the map, which needs no attitude and, with north up, no heading
};

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
[[nodiscard]] const SignalRule& signal_rule(flight::Signal signal) noexcept;
[[nodiscard]] std::uint8_t consequences(const SignalRule& rule, base::SignalState state) noexcept;

[[nodiscard]] DisplayDecisions decide_display(const flight::AircraftState& state, base::Time now,
                                              const DisplayConditions& conditions, const design::DesignSettings& design) noexcept;

}  // namespace tedavis::policy
