/// Queries the true surface of a terrain database for a sweep: its height, and whether it hides a place from a viewpoint.
#pragma once

#include <cstddef>
#include <vector>

#include "render_core/terrain/height_query.hpp"

namespace tedavis::host_sim {

class SweptGround {
public:
    /// The database must outlive this object.
    explicit SweptGround(const terrain::TerrainDatabase& database);

    [[nodiscard]] terrain::HeightAnswer at(double latitude_rad, double longitude_rad) {
        return query_.at(latitude_rad, longitude_rad);
    }
    /// Samples the line of sight every eighth of a post, except its last hundredth, so that ground does not hide a place on it.
    /// Where no height is known nothing hides.
    [[nodiscard]] bool hides(const earth::Geodetic& place, const earth::Geodetic& eye);
    /// The middle of the lattice, at height 0.
    [[nodiscard]] earth::Geodetic middle() const;

private:
    const terrain::TerrainDatabase& database_;
    std::vector<std::byte> memory_;
    terrain::HeightQuery query_;
};

}  // namespace tedavis::host_sim
