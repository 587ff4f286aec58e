/// Plans what the maps beside the picture show, from the scene and the design.
///
/// Their time is that of the ground's data (spatial_data.hpp). Pure functions; any thread. Pointers point into the scene and are
/// valid for this frame only.
#pragma once

#include "render_core/display/planner/data_legends.hpp"
#include "render_core/draw/symbology/adjacent_maps.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::display {

struct AdjacentData {
    GroundDataState state = GroundDataState::not_asked_for;  ///< for any other than `shown` there are no maps
    draw::AdjacentInput maps;
};

/// `place`: position of the own ship; `sign`: the colour of missing and unknown values.
[[nodiscard]] AdjacentData plan_adjacent_data(const SpatialData& data, const design::AdjacentView& view,
                                              const earth::Geodetic& place, const flight::FlightTime& time,
                                              design::Color sign) noexcept;

/// Adds the scale of the maps, where they are shown and no other legend has the same content.
void add_adjacent_legend(const AdjacentData& data, const flight::FlightTime& time, const design::DesignSettings& design,
                         draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
