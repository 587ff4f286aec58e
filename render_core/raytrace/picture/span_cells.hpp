/// The surface of the cells that up to 64 rays hit: heights and slopes from the posts of each cell.
///
/// The loops have no branches, so that compilers vectorise them. Pure; any thread.
#pragma once

#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

/// The cells of a span. Those of rays without a hit may be any cell.
struct SpanCells {
    float corner[4][PixelSpan::kMax];              ///< posts, as HitCell numbers them
    float u[PixelSpan::kMax], v[PixelSpan::kMax];  ///< position in the cell, 0..1
};

/// Writes the heights and slopes of the `out.count` first cells; `parts` is the number of cells per post of the scene.
void find_cell_surface(const SpanCells& cells, CellSurface surface, float parts, SpanSurface& out);

}  // namespace tedavis::raytrace
