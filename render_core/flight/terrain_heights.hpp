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

/// Of an object that has the function and does not know the port. The object must outlive it.
template <class Ground>
class HeightsOver final : public TerrainHeights {
public:
    explicit HeightsOver(Ground& ground) : ground_(ground) {}
    [[nodiscard]] base::Stamped<double> height_above_terrain(const OwnShipEstimate& own_ship, base::Time now) override {
        return ground_.height_above_terrain(own_ship, now);
    }

private:
    Ground& ground_;
};

}  // namespace tedavis::flight
