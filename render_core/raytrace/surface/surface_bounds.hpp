/// Bounds of every cell for a HeightMipmap, for any surface over the posts.
///
/// A bound is that of the cell's patch (cell_patch.hpp; for a cubic one the extreme control height), enlarged by the amplitude of
/// the micro-structure and rounded outwards to Height. No height of CellPatch::at() plus micro_structure_at() exceeds it. The
/// highest of the four posts would not be a bound of a bicubic surface.
///
/// Cost: 16 posts and about 50 operations per cell for cubic surfaces.
#pragma once

#include "render_core/raytrace/cell_bounds.hpp"
#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {

/// Returns bounds for a HeightMipmap; the settings must outlive them. Piecewise flat surfaces use the mipmap's own bounds.
template <class Height>
[[nodiscard]] CellBounds<Height> surface_bounds(const SurfaceSettings& settings);

/// True where every bound fits Height: always for float; false where std::int16_t heights are so close to the type's limits
/// that the surface might exceed them (by half of their range and the amplitude). Where it is false, bounds are not valid.
template <class Height>
[[nodiscard]] bool surface_fits(const HeightGrid<Height>& grid, const SurfaceSettings& settings);

/// Round a height up and down to Height; never to the void value or out of the type's range.
template <class Height>
[[nodiscard]] Height rounded_up(double height);
template <class Height>
[[nodiscard]] Height rounded_down(double height);

}  // namespace tedavis::raytrace
