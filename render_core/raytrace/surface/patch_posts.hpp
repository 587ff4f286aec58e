/// The 4 x 4 posts that a cubic patch of a cell is made from.
///
/// A cell has a surface where its own four posts have heights, whatever lies round them: nothing is put where no height is. Posts
/// of the ring that lie beyond the border or are void are continued straight from the cell's own side: post[-1] = 2 post[0] -
/// post[1]. They bend the surface of this cell only. A corner of the ring within the grid that is void continues its two
/// neighbours: side + side - own corner. A plane stays a plane everywhere. Neighbouring cells continue what they share alike, so
/// that the surface has no gap; its slope has no jump either, except across the sides of a cell whose corner of the ring is void.
#pragma once

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

struct PatchPosts {
    bool has_surface = false;  ///< else the heights mean nothing
    double z[4][4] = {};       ///< z[row + 1][column + 1] of the cell's first post
};

/// Sums of few heights: exact for std::int16_t, rounded as doubles for float.
template <class Height>
[[nodiscard]] PatchPosts patch_posts(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row);

}  // namespace tedavis::raytrace
