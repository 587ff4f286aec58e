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

/// A ray of the world: metres, ECEF.
struct WorldRay {
    earth::Ecef origin{0};
    glm::dvec3 direction{0};  ///< of unit length
    double metres_of_t = 1;   ///< of the ray of grid space that it was: so many are a unit of its t
};

class GroundSpace {
public:
    GroundSpace() = default;  ///< of nothing
    /// `window`: the posts that the grid holds, in the lattice (both ends included). `step_m`: metres of a height step, more than
    /// 0.
    GroundSpace(const terrain::TerrainDatabase& database, const terrain::PostRange& window, double step_m);

    [[nodiscard]] bool is_set() const { return database_ != nullptr; }
    /// The space of a grid with so many posts to one of this.
    [[nodiscard]] GroundSpace refined(std::uint32_t parts) const;

    [[nodiscard]] static bool fits(const terrain::Lattice& lattice, const terrain::PostRange& window);

    /// Goes on beyond the window and the lattice.
    [[nodiscard]] glm::dvec3 place(const earth::Ecef& position) const;
    [[nodiscard]] earth::Ecef position(const glm::dvec3& place) const;
    /// The ray that runs as this one does where it begins.
    [[nodiscard]] WorldRay world_ray(const glm::dvec3& origin, const glm::dvec3& direction) const;
    [[nodiscard]] double step_m() const { return step_m_; }
    [[nodiscard]] const terrain::PostRange& window() const { return window_; }
    /// Metres from a column to the next on a row, and from a row to the next, at the row of the window.
    [[nodiscard]] double column_m(double row) const;
    [[nodiscard]] double row_m(double row) const;

private:
    [[nodiscard]] double latitude_rad(double row) const;

    const terrain::TerrainDatabase* database_ = nullptr;
    terrain::PostRange window_;
    double step_m_ = 1;
    double west_deg_ = 0, north_deg_ = 0, step_lon_deg_ = 1, step_lat_deg_ = 1;  ///< of the window
    double half_width_deg_ = 0;
};

}  // namespace tedavis::raytrace
