/// Bounds of every cell for a HeightMipmap, whatever surface lies over the posts.
///
/// Of the cell's patch (cell_patch.hpp: of a cubic one the extreme control heights), and beyond them the amplitude of the
/// micro-structure; rounded outwards to Height. No height that CellPatch::at() plus micro_structure_at() returns exceeds them
/// (NUMERICS A24, findings 4 and 8); the highest of the four posts would not do for a bicubic surface.
///
/// Cost: 16 posts and some 50 operations a cell for cubic surfaces.
#pragma once

#include "render_core/raytrace/cell_bounds.hpp"
#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {

/// To be given to a HeightMipmap; borrows the settings. What is between flat sides needs no more than the mipmap's own bounds.
template <class Height>
[[nodiscard]] CellBounds<Height> surface_bounds(const SurfaceSettings& settings);

/// Whether every bound is a Height: always where Height is float; false where std::int16_t heights come so close to its limits
/// that a surface between them might leave it (by half of their range and the amplitude). Where it does not, bounds would not
/// hold.
template <class Height>
[[nodiscard]] bool surface_fits(const HeightGrid<Height>& grid, const SurfaceSettings& settings);

/// The least Height that is not below a height, and the greatest that is not above it. Never Height's void, nor what an int16
/// cannot hold.
template <class Height>
[[nodiscard]] Height rounded_up(double height);
template <class Height>
[[nodiscard]] Height rounded_down(double height);

}  // namespace tedavis::raytrace
