/// Grid space over the Earth: columns and rows of a terrain database's lattice, heights above mean sea level.
///
/// In this space the true surface is straight between posts, while rays of the world are bent by the Earth's curvature, the
/// convergence of meridians and the geoid. straight_pieces.hpp divides rays into pieces that are straight enough.
///
/// Frames  ECEF in metres; grid space as in height_grid.hpp, column and row 0 being the first of a window of the lattice.
/// Limits  rows beside a pole, which have a different spacing, and lattices round the Earth have no such space; fits() is false
/// for them. Thread  const, any. The database must outlive the space.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::raytrace {

/// A ray of the world: metres, ECEF.
struct WorldRay {
    earth::Ecef origin{0};
    glm::dvec3 direction{0};  ///< of unit length
    double metres_of_t = 1;   ///< metres per unit of t of the ray in grid space
};

class GroundSpace {
public:
    GroundSpace() = default;  ///< an unset space
    /// `window` is the grid's range of posts in the lattice (both ends included), `step_m` the metres per height step, above 0.
    GroundSpace(const terrain::TerrainDatabase& database, const terrain::PostRange& window, double step_m);

    [[nodiscard]] bool is_set() const { return database_ != nullptr; }
    /// Returns the space of a grid with `parts` posts per post.
    [[nodiscard]] GroundSpace refined(std::uint32_t parts) const;

    [[nodiscard]] static bool fits(const terrain::Lattice& lattice, const terrain::PostRange& window);

    /// Converts an ECEF position to grid space; it is extrapolated beyond the window and the lattice.
    [[nodiscard]] glm::dvec3 place(const earth::Ecef& position) const;
    [[nodiscard]] earth::Ecef position(const glm::dvec3& place) const;
    /// Returns the world ray that is tangent to a ray of grid space at its origin.
    [[nodiscard]] WorldRay world_ray(const glm::dvec3& origin, const glm::dvec3& direction) const;
    [[nodiscard]] double step_m() const { return step_m_; }
    [[nodiscard]] const terrain::PostRange& window() const { return window_; }
    /// Spacing of columns and of rows in metres, at a row of the window.
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
