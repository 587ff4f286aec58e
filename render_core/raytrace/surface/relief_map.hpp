/// Relief finer than the posts from a tile of heights that is repeated over the grid, bilinear between its posts.
///
/// The tile's first column follows its last one. A post of the tile without a height adds nothing. |height| <= amplitude holds
/// bit for bit. Pure; any thread; reads four posts per point.
#pragma once

#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

struct ReliefMap {
    HeightGrid<std::int16_t> tile;                 ///< borrowed
    double full_scale = 32767;                     ///< the tile's height for the amplitude, above 0; greater ones are clamped
    double amplitude = 1;                          ///< height steps of the grid, 0 or more
    double density = 8;                            ///< posts of the tile per post of the grid, above 0
    std::int64_t first_column = 0, first_row = 0;  ///< origin of the grid among neighbouring grids
};

/// Returns the relief at x and y of grid space.
[[nodiscard]] SurfacePoint relief_at(const ReliefMap& map, double x, double y);

/// Upper bound of its slopes along x or y, in height steps per post.
[[nodiscard]] double steepest_slope(const ReliefMap& map);

}  // namespace tedavis::raytrace
