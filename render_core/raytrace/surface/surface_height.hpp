/// The surface at a point of the grid: patch of its cell plus micro-structure.
#pragma once

#include <algorithm>
#include <cmath>

#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {

struct CellPlace {
    std::uint32_t column = 0, row = 0;
    double u = 0, v = 0;  ///< 0..1
};

/// Finds the cell of a point; on the grid's far border the last one. Returns false outside the grid.
template <class Height>
[[nodiscard]] bool find_cell(const HeightGrid<Height>& grid, double x, double y, CellPlace& place) {
    if (!(x >= 0 && y >= 0 && x <= grid.columns - 1 && y <= grid.rows - 1)) return false;
    place.column = std::min(static_cast<std::uint32_t>(x), grid.columns - 2);
    place.row = std::min(static_cast<std::uint32_t>(y), grid.rows - 2);
    place.u = x - place.column;
    place.v = y - place.row;
    return true;
}

/// Returns a patch plus the micro-structure; x and y are in grid space, within the patch's cell.
[[nodiscard]] inline SurfacePoint surface_on(const CellPatch& patch, const MicroStructure& micro, const CellPlace& place) {
    SurfacePoint point = patch.at(place.u, place.v);
    if (micro.kind == MicroKind::none) return point;
    const SurfacePoint added = micro_structure_at(micro, place.column + place.u, place.row + place.v);
    point.height += added.height;
    point.slope_x += added.slope_x;
    point.slope_y += added.slope_y;
    return point;
}

/// Computes the surface at a point; returns false where there is none.
template <class Height>
[[nodiscard]] bool find_surface(const HeightGrid<Height>& grid, const SurfaceSettings& settings, double x, double y,
                                SurfacePoint& point) {
    CellPlace place;
    if (!find_cell(grid, x, y, place)) return false;
    const CellPatch patch = cell_patch(grid, settings, place.column, place.row);
    if (patch.has_surface) point = surface_on(patch, settings.micro, place);
    return patch.has_surface;
}

}  // namespace tedavis::raytrace
