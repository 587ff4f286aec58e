/// Finds the exact first hit of a ray with the terrain, one ray at a time, for queries; pictures use view_kernels.hpp.
///
/// The maximum mipmap is traversed from node to node (Tevs et al. 2008); within a cell the intersection is computed, not
/// searched. A ray passes a node that it lies above. No ray passes between neighbouring cells: the surface is continuous, so a
/// ray that is below it at the entry of a cell hits it there. Cells are separated by the times at which grid lines are crossed,
/// which are the same number for both sides of a line.
///
/// Numbers are 32-bit floats relative to the origin's cell: errors grow with the distance from the origin, not with the
/// position in the grid.
///
/// Pure; any thread. Bounded by the cells that a line crosses, times the levels.
#pragma once

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

/// The surface between the four posts of a cell.
enum class CellSurface : std::uint8_t {
    two_triangles,  ///< divided from (column + 1, row) to (column, row + 1): the true surface of a terrain database
    bilinear,       ///< not the true surface
};

/// Heights with their bounds; borrowed.
template <class Height>
struct TracedField {
    const HeightMipmap<Height>* maxima = nullptr;
    /// Null: a ray that is below the surface, from its beginning or through a hole, has no hit.
    const HeightMipmap<Height>* minima = nullptr;
    CellSurface surface = CellSurface::two_triangles;

    [[nodiscard]] const HeightGrid<Height>& grid() const { return maxima->grid(); }
};

template <class Height>
[[nodiscard]] Hit trace_ray(const TracedField<Height>& field, const Ray& ray);

}  // namespace tedavis::raytrace
