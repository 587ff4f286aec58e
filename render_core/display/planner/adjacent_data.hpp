/// What the maps beside the picture show, from the scene and the design.
///
/// Time as of the ground's data (spatial_data.hpp). Pure; any thread. Pointers are the scene's: for this frame only.
#pragma once

#include "render_core/display/planner/data_legends.hpp"
#include "render_core/draw/symbology/adjacent_maps.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::display {

struct AdjacentData {
    GroundDataState state = GroundDataState::not_asked_for;  ///< for any other than `shown` there are no maps
    draw::AdjacentInput maps;
};

/// `place`: of the own ship; `sign`: the colour of what is missing or unknown.
[[nodiscard]] AdjacentData plan_adjacent_data(const SpatialData& data, const design::AdjacentView& view,
                                              const earth::Geodetic& place, const flight::FlightTime& time,
                                              design::Color sign) noexcept;

/// The scale of the maps, where they are shown and no other legend says the same.
void add_adjacent_legend(const AdjacentData& data, const flight::FlightTime& time, const design::DesignSettings& design,
                         draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
