/// Grid space over the Earth: columns and rows of a terrain database's lattice, heights above mean sea level.
///
/// The true surface has straight pieces between posts there, rays of the world have not: the Earth's curvature, the meridians
/// that draw together and the geoid bend them. straight_pieces.hpp cuts them in pieces that are straight enough.
///
/// Frames  ECEF in metres; grid space as in height_grid.hpp, column and row 0 being the first of a window of the lattice.
/// Limits  rows beside a pole, which have a spacing of their own, and lattices round the Earth have no such space: fits() says
/// so. Thread  const, any. Borrows the database.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::raytrace {

class GroundSpace {
public:
    /// `window`: the posts that the grid holds, in the lattice (both ends included). `step_m`: metres of a height step, more than
    /// 0.
    GroundSpace(const terrain::TerrainDatabase& database, const terrain::PostRange& window, double step_m);

    [[nodiscard]] static bool fits(const terrain::Lattice& lattice, const terrain::PostRange& window);

    /// Goes on beyond the window and the lattice.
    [[nodiscard]] glm::dvec3 place(const earth::Ecef& position) const;
    [[nodiscard]] earth::Ecef position(const glm::dvec3& place) const;
    [[nodiscard]] double step_m() const { return step_m_; }
    [[nodiscard]] const terrain::PostRange& window() const { return window_; }
    /// Metres from a column to the next on a row, and from a row to the next, at the row of the window.
    [[nodiscard]] double column_m(double row) const;
    [[nodiscard]] double row_m(double row) const;

private:
    [[nodiscard]] double latitude_rad(double row) const;

    const terrain::TerrainDatabase* database_;
    terrain::PostRange window_;
    double step_m_;
    double west_deg_, north_deg_, step_lon_deg_, step_lat_deg_;  ///< of the window
    double half_width_deg_;
};

}  // namespace tedavis::raytrace
