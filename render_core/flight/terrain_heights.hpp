/// Port: how high an aircraft is above the terrain. Whoever has the terrain answers; the phase and the display need the answer.
#pragma once

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

class TerrainHeights {
public:
    virtual ~TerrainHeights() = default;
    /// In metres; nothing received where the place or the terrain below it is not known. Never blocks, never allocates.
    [[nodiscard]] virtual base::Stamped<double> height_above_terrain(const OwnShipEstimate& own_ship, base::Time now) = 0;
};

}  // namespace tedavis::flight
