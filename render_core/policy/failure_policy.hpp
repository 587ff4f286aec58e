/// Decides what the display shows when signals are missing, stale, lost or invalid. Pure function.
///
/// The whole table is in render_core/display/README.md; signal_rules.hpp has it for the program. After AC 25-11B 6.2.1.7 a
/// failure is shown in the place of the information, and stale data are never shown as valid; terrain follows the rule of the
/// synthetic-vision manuals (Garmin 190-02177: disabled without attitude, heading, position or database).
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"
#include "render_core/base/valid_period.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/signal_rules.hpp"
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
    bool terrain_ends = false;          ///< the predicted track leaves the database within the alert's look-ahead
    bool terrain_is_coarse = false;     ///< because of budgets its error exceeds the design's limit
    bool image_is_missing = false;      ///< the design shows an image over the terrain, and there is none
    bool data_are_out_of_date = false;  ///< spatial data that the design shows are not valid at this time, and left out
    bool data_are_stale = false;        ///< spatial data that the design shows are older than its limit
    base::Currency databases = base::Currency::current;  ///< by their dates; they are shown in any case
    bool is_reduced = false;     ///< the picture is reduced for the frame's deadline, and the design requests a notice
    bool shows_measure = false;  ///< colours show a measure of the picture (saliency, clutter)
    TerrainAhead terrain_ahead = TerrainAhead::none;
    TerrainAhead obstacle_ahead = TerrainAhead::none;
    bool is_map = false;  ///< the picture is the map, which needs no attitude and, with north up, no heading
};

[[nodiscard]] DisplayDecisions decide_display(const flight::AircraftState& state, base::Time now,
                                              const DisplayConditions& conditions, const design::DesignSettings& design) noexcept;

}  // namespace tedavis::policy
