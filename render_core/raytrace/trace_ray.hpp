/// The first point of the terrain on a ray, exactly: one ray after the other, for queries; pictures have view_kernels.hpp.
///
/// Traversal of the maximum mipmap from node to node (Tevs et al. 2008); within a cell the surface itself is met, not approached.
/// A ray that lies above all of a node's heights there passes it. Neighbouring cells cannot be slipped between: the surface is
/// continuous, so a ray that is below it where it enters a cell has met it there. Cells are told apart by comparing the times at
/// which grid lines are crossed, which are one number for both their sides.
///
/// Numbers are 32-bit floats relative to the origin's own cell: errors grow with the distance from the origin, not with the place
/// in the grid.
///
/// Pure; any thread. Bounded by the cells that a line crosses, times the levels.
#pragma once

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

/// What lies between the four posts of a cell.
enum class CellSurface : std::uint8_t {
    two_triangles,  ///< divided from (column + 1, row) to (column, row + 1): the true surface of a terrain database
    bilinear,       ///< another surface than that
};

/// Heights with their bounds; borrowed.
template <class Height>
struct TracedField {
    const HeightMipmap<Height>* maxima = nullptr;
    /// Null: a ray that is below the surface, from its beginning or through a hole, meets nothing more.
    const HeightMipmap<Height>* minima = nullptr;
    CellSurface surface = CellSurface::two_triangles;

    [[nodiscard]] const HeightGrid<Height>& grid() const { return maxima->grid(); }
};

template <class Height>
[[nodiscard]] Hit trace_ray(const TracedField<Height>& field, const Ray& ray);

}  // namespace tedavis::raytrace
