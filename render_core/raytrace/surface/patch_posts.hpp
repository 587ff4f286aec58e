/// The 4 x 4 posts that a cubic patch of a cell is made from.
///
/// A cell has a surface where its four posts have heights, whatever surrounds them. Posts of the surrounding ring that lie
/// outside the grid or are void are extrapolated linearly from the cell's side: post[-1] = 2 post[0] - post[1]. They influence
/// the surface of this cell only. A void corner of the ring inside the grid is extrapolated from its two neighbours:
/// side + side - own corner. Planes are reproduced everywhere. Neighbouring cells extrapolate shared posts equally, so the
/// surface has no gap; its slope is continuous too, except across the sides of a cell whose ring has a void corner.
#pragma once

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

struct PatchPosts {
    bool has_surface = false;  ///< false: the heights are meaningless
    double z[4][4] = {};       ///< indices are z[row + 1][column + 1], relative to the cell's first post
};

/// Reads the posts. Extrapolation is exact for std::int16_t and rounded to double for float.
template <class Height>
[[nodiscard]] PatchPosts patch_posts(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row);

}  // namespace tedavis::raytrace
