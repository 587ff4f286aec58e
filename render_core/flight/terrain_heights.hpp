/// Port: the height of an aircraft above the terrain, provided by the owner of the terrain and used by flight phase and
/// display.
#pragma once

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

class TerrainHeights {
public:
    virtual ~TerrainHeights() = default;
    /// Returns the height in metres; the value counts as never received where the position or the terrain below it is unknown.
    /// Never blocks, never allocates.
    [[nodiscard]] virtual base::Stamped<double> height_above_terrain(const OwnShipEstimate& own_ship, base::Time now) = 0;
};

}  // namespace tedavis::flight
