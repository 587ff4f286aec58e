#include "render_core/raytrace/picture/span_cells.hpp"

#include "render_core/raytrace/picture/wide_loops.hpp"

namespace tedavis::raytrace {
namespace {

TEDAVIS_WIDE_LOOPS void find_bilinear(const SpanCells& __restrict cells, float parts, SpanSurface& __restrict out) {
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float a = cells.corner[0][n], b = cells.corner[1][n], c = cells.corner[2][n], d = cells.corner[3][n];
        const float u = cells.u[n], v = cells.v[n];
        const float slope_x = (1 - v) * (b - a) + v * (d - c), slope_y = (1 - u) * (c - a) + u * (d - b);
        out.height[n] = a + u * (b - a) + v * slope_y;
        out.slope_x[n] = slope_x * parts;
        out.slope_y[n] = slope_y * parts;
    }
}

TEDAVIS_WIDE_LOOPS void find_triangles(const SpanCells& __restrict cells, float parts, SpanSurface& __restrict out) {
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float a = cells.corner[0][n], b = cells.corner[1][n], c = cells.corner[2][n], d = cells.corner[3][n];
        const float u = cells.u[n], v = cells.v[n];
        const bool is_first = u + v <= 1;
        const float slope_x = is_first ? b - a : d - c, slope_y = is_first ? c - a : d - b;
        const float base = is_first ? a : d, along_x = is_first ? u : u - 1, along_y = is_first ? v : v - 1;
        out.height[n] = base + along_x * slope_x + along_y * slope_y;
        out.slope_x[n] = slope_x * parts;
        out.slope_y[n] = slope_y * parts;
    }
}

}  // namespace

void find_cell_surface(const SpanCells& cells, CellSurface surface, float parts, SpanSurface& out) {
    const auto find = surface == CellSurface::bilinear ? find_bilinear : find_triangles;
    find(cells, parts, out);
}

}  // namespace tedavis::raytrace
