/// The first point of any surface of surface/ on a ray: the tracer for smooth and micro-structured surfaces, one ray at a time.
///
/// Nodes of the maximum mipmap (Tevs et al. 2008), whose bounds must be those of this surface (surface_bounds.hpp), then the
/// crossing of each cell (cell_crossing.hpp). Double throughout, and with no part of the SIMD tracer's arithmetic: it also serves
/// as that one's reference. A ray that begins below the surface meets it from below; one that enters through the border, or from
/// a cell without a surface, below what lies there does as well.
///
/// Pure; any thread; bounded by the nodes that a line crosses.
#pragma once

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/search/surface_hit.hpp"

namespace tedavis::raytrace {

/// `counts` may be null.
template <class Height>
[[nodiscard]] SurfaceHit trace_surface(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const Ray& ray,
                                       TraceCounts* counts = nullptr);

}  // namespace tedavis::raytrace
