/// What the symbology of a frame shows of its spatial data (legends, and maps beside the picture) and of the aircraft's speeds.
/// Pure functions; any thread.
#pragma once

#include "render_core/design/aircraft_settings.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/policy/speed_bands.hpp"

namespace tedavis::display {

/// Maps beside the picture.
struct MapsBeside {
    GroundDataState state = GroundDataState::not_asked_for;
    std::uint32_t drawn = 0;  ///< how many, where they are shown
};

/// It refers to the display's objects.
struct SymbologyData {
    const SpatialData& data;
    const SpatialDataPlan& plan;
    const ElementReports& reports;
    const design::DesignSettings& design;
    const earth::Geodetic& place;  ///< of the own ship
    const flight::FlightTime& time;
};
/// Fills `symbology`, and says whether there are maps beside the picture.
[[nodiscard]] GroundDataState add_symbology_data(const SymbologyData& frame, draw::SymbologyInput& symbology) noexcept;

/// Returns the bands of the airspeed tape; none where the tape shows neither indicated nor calibrated airspeed, since the bands
/// are of these.
[[nodiscard]] policy::SpeedBands shown_speed_bands(const design::AircraftSettings& aircraft, const flight::AircraftState& state,
                                                   const policy::DisplayDecisions& decisions, base::Time now) noexcept;

/// Returns the number of the frame's maps that have room.
[[nodiscard]] std::uint32_t maps_drawn(const draw::SymbologyInput& symbology, const draw::Layout& layout) noexcept;
/// Flags what should be there and has no room, or no data.
void flag_symbology_data(const draw::SymbologyInput& symbology, const draw::Layout& layout, GroundDataState maps,
                         FrameStatement& record) noexcept;

}  // namespace tedavis::display
