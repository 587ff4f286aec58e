#include "render_core/raytrace/picture/span_cells.hpp"

#include <gtest/gtest.h>

#include <random>

#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace::test_span_cells {
namespace {

/// Cells with the posts of a made grid, two in its middle.
struct MadeCells {
    explicit MadeCells(std::uint32_t seed) {
        std::mt19937 random(seed);
        const auto any = [&](float high) { return std::uniform_real_distribution<float>(0, high)(random); };
        for (std::uint32_t n = 0; n < PixelSpan::kMax; ++n) {
            cells.u[n] = any(1);
            cells.v[n] = any(1);
            for (int k = 0; k < 4; ++k) cells.corner[k][n] = any(500);
        }
    }
    [[nodiscard]] SurfacePoint expected(std::uint32_t n, SurfaceKind kind) const {
        const float posts[4] = {cells.corner[0][n], cells.corner[1][n], cells.corner[2][n], cells.corner[3][n]};
        SurfaceSettings settings;
        settings.kind = kind;
        return cell_patch(HeightGrid<float>{posts, 2, 2, 2}, settings, 0, 0).at(cells.u[n], cells.v[n]);
    }
    SpanCells cells;
};

TEST(SpanCells, SurfacesAreThoseOfSingleCells) {
    const MadeCells made(1);
    for (const auto& [surface, kind] : {std::pair{CellSurface::two_triangles, SurfaceKind::two_triangles},
                                        std::pair{CellSurface::bilinear, SurfaceKind::bilinear}}) {
        SpanSurface found;
        found.count = PixelSpan::kMax;
        find_cell_surface(made.cells, surface, 3, found);
        for (std::uint32_t n = 0; n < found.count; ++n) {
            const SurfacePoint point = made.expected(n, kind);
            EXPECT_NEAR(found.height[n], point.height, 1e-3);
            EXPECT_NEAR(found.slope_x[n], 3 * point.slope_x, 1e-3) << "of cells a third as wide";
            EXPECT_NEAR(found.slope_y[n], 3 * point.slope_y, 1e-3);
        }
    }
}

TEST(SpanCells, TheTwoSurfacesDiffer) {
    const MadeCells made(2);
    SpanSurface triangles, bilinear;
    triangles.count = bilinear.count = PixelSpan::kMax;
    find_cell_surface(made.cells, CellSurface::two_triangles, 1, triangles);
    find_cell_surface(made.cells, CellSurface::bilinear, 1, bilinear);
    std::uint32_t different = 0;
    for (std::uint32_t n = 0; n < PixelSpan::kMax; ++n) different += std::abs(triangles.height[n] - bilinear.height[n]) > 1;
    EXPECT_GT(different, PixelSpan::kMax / 2);
}

}  // namespace
}  // namespace tedavis::raytrace::test_span_cells
