/// **Inexact.** Finds the first hit of a ray with a surface by uniform steps and bisection (uniform_search.hpp): within the
/// cells that the maximum mipmap leaves, or over the whole ray without it, as the thesis's tracer does.
///
/// What goes wrong within cells: what dips into a cell and out again between two steps. With four steps a cell no ray in ten
/// thousand is off by more than a cell (test_search_surface.cpp). Over the whole ray: everything that uniform_search.hpp says.
#pragma once

#include "render_core/raytrace/search/trace_surface.hpp"
#include "render_core/raytrace/search/uniform_search.hpp"

namespace tedavis::raytrace {

/// `search.steps` in each cell that the ray may meet something in.
template <class Height>
[[nodiscard]] SurfaceHit search_cells(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const Ray& ray,
                                      const UniformSearch& search, TraceCounts* counts = nullptr);

/// `search.steps` from where the ray enters the grid to where it leaves it; it must do both at a finite t, or have an end.
template <class Height>
[[nodiscard]] SurfaceHit search_ray(const HeightGrid<Height>& grid, const SurfaceSettings& settings, const Ray& ray,
                                    const UniformSearch& search);

}  // namespace tedavis::raytrace
