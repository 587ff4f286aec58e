/// The surface within one cell, of any kind, without micro-structure: height, slopes and bounds.
///
/// u and v, 0..1, run from the cell's first post along its row and its column. Neighbouring cells have equal heights along the
/// side that they share, bit for bit. Slopes along creases are those of the triangle or small cell with the lower u and v.
#pragma once

#include "render_core/raytrace/surface/bicubic_patch.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

struct HeightRange {
    double lowest = 0, highest = 0;
};

struct CellPatch {
    SurfaceKind kind = SurfaceKind::bilinear;
    bool has_surface = false;  ///< false: the other members are meaningless
    std::uint32_t subdivisions = 1;
    double corner[2][2] = {};  ///< heights of the posts, [row][column]
    BicubicPatch cubic;        ///< for the two bicubic kinds

    [[nodiscard]] SurfacePoint at(double u, double v) const;
    /// Height of a point of the approximation, 0..subdivisions in each direction.
    [[nodiscard]] double small_post(std::uint32_t column, std::uint32_t row) const;
    /// Range of all heights that at() can return, from the posts or the control heights.
    [[nodiscard]] HeightRange range() const;
};

template <class Height>
[[nodiscard]] CellPatch cell_patch(const HeightGrid<Height>& grid, const SurfaceSettings& settings, std::uint32_t column,
                                   std::uint32_t row);

/// Bilinear between four heights, [row][column].
[[nodiscard]] SurfacePoint bilinear_at(const double corner[2][2], double u, double v);

}  // namespace tedavis::raytrace
