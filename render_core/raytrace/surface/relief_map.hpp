/// Relief finer than the posts from a map that is repeated over the grid: heights of one tile, bilinear between its posts.
///
/// The tile repeats: after its last column comes its first. A post of the tile without a height has none to add. Bounds that hold
/// bit for bit: |height| <= amplitude. Pure; any thread; four posts a place.
#pragma once

#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

struct ReliefMap {
    HeightGrid<std::int16_t> tile;                 ///< borrowed
    double full_scale = 32767;                     ///< the tile's height that becomes the amplitude; higher ones are cut. Above 0
    double amplitude = 1;                          ///< height steps of the grid, 0 or more
    double density = 8;                            ///< posts of the tile to a post of the grid, above 0
    std::int64_t first_column = 0, first_row = 0;  ///< of the grid, among grids that lie side by side
};

/// x and y in grid space.
[[nodiscard]] SurfacePoint relief_at(const ReliefMap& map, double x, double y);

/// No slope of it is steeper than this, along x or along y, in height steps a post.
[[nodiscard]] double steepest_slope(const ReliefMap& map);

}  // namespace tedavis::raytrace
