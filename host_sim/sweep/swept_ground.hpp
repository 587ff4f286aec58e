/// The true surface of a terrain database, asked by a sweep: how high it is, and whether it stands between an eye and a place.
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
    /// Looks every eighth of a post, up to the last hundredth of the way: what stands on the ground is not hidden by it. Where
    /// no height is known nothing hides.
    [[nodiscard]] bool hides(const earth::Geodetic& place, const earth::Geodetic& eye);
    /// The middle of the lattice, at height 0.
    [[nodiscard]] earth::Geodetic middle() const;

private:
    const terrain::TerrainDatabase& database_;
    std::vector<std::byte> memory_;
    terrain::HeightQuery query_;
};

}  // namespace tedavis::host_sim
