/// **Inexact.** Finds the first hit of a ray with a surface by uniform steps and bisection (uniform_search.hpp): within the
/// cells that the maximum mipmap leaves, or over the whole ray without it, as the thesis's tracer does.
///
/// What goes wrong within cells: rays that dip below the surface between two steps are not found. With four steps per cell no ray
/// in ten thousand is wrong by more than a cell (test_search_surface.cpp). Over the whole ray: all errors of uniform_search.hpp.
#pragma once

#include "render_core/raytrace/search/trace_surface.hpp"
#include "render_core/raytrace/search/uniform_search.hpp"

namespace tedavis::raytrace {

/// Searches with `search.steps` steps in each cell that the ray may hit. `counts` may be null.
template <class Height>
[[nodiscard]] SurfaceHit search_cells(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const Ray& ray,
                                      const UniformSearch& search, TraceCounts* counts = nullptr);

/// Searches with `search.steps` steps between the points at which the ray enters and leaves the grid; both must have a finite t,
/// or the ray a finite end.
template <class Height>
[[nodiscard]] SurfaceHit search_ray(const HeightGrid<Height>& grid, const SurfaceSettings& settings, const Ray& ray,
                                    const UniformSearch& search);

}  // namespace tedavis::raytrace
