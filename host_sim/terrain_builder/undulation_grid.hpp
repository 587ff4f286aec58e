/// The geoid's height above the ellipsoid over one lattice: the nodes that a database carries, and bilinear values at posts.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

inline constexpr double kUndulationStep_deg = 0.25;

struct UndulationGrid {
    double west_deg = 0, north_deg = 0;
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> undulation_m;  ///< row 0 in the north

    /// Nodes over a rectangle, with at least two columns and rows.
    [[nodiscard]] static UndulationGrid covering(double west_deg, double south_deg, double east_deg, double north_deg,
                                                 const GeoidEgm96& geoid);
    /// Places outside take the nearest node's.
    [[nodiscard]] double at(double latitude_deg, double longitude_deg) const;
};

/// The undulation at posts of a window: the same bits for a post, whichever window it is asked in.
class PostUndulation {
public:
    PostUndulation(const UndulationGrid& grid, const terrain::Lattice& lattice) : grid_(grid), lattice_(lattice) {}

    /// Of `columns` posts of row j, from column i0 on. Columns may lie beyond the lattice; round the Earth they go on.
    void row(std::int64_t i0, std::uint32_t columns, std::uint32_t j, std::vector<double>& undulation_m) const;

private:
    const UndulationGrid& grid_;
    const terrain::Lattice& lattice_;
};

}  // namespace tedavis::host_sim
