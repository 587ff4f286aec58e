/// The geoid's height above the ellipsoid over one lattice: the nodes stored in a database, and bilinear values at posts.
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
    /// Outside the grid, the value of the nearest border point.
    [[nodiscard]] double at(double latitude_deg, double longitude_deg) const;
};

/// The undulation at posts of a window; a post has the same bits in every window.
class PostUndulation {
public:
    PostUndulation(const UndulationGrid& grid, const terrain::Lattice& lattice) : grid_(grid), lattice_(lattice) {}

    /// Computes the undulation of `columns` posts of row j, from column i0 on, metres. Columns may be beyond the lattice; a
    /// lattice round the Earth is continued.
    void row(std::int64_t i0, std::uint32_t columns, std::uint32_t j, std::vector<double>& undulation_m) const;

private:
    const UndulationGrid& grid_;
    const terrain::Lattice& lattice_;
};

}  // namespace tedavis::host_sim
