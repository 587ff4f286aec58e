/// The geoid at any position in the simulator: that of the terrain database, else the installed EGM96 grid.
#pragma once

#include <optional>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

class GeoidBelow {
public:
    /// `database` may be null; it must outlive this object.
    explicit GeoidBelow(const terrain::TerrainDatabase* database) : database_(database) {}
    /// The grid is read when it is first needed; throws UserError when it is not installed then.
    [[nodiscard]] earth::GeoidUndulation at(double latitude_rad, double longitude_rad);

private:
    const terrain::TerrainDatabase* database_;
    std::optional<GeoidEgm96> grid_;
};

}  // namespace tedavis::host_sim
