/// Finds the first hit of a ray with any surface of surface/: the tracer for smooth and micro-structured surfaces, one ray at a
/// time.
///
/// It traverses the maximum mipmap (Tevs et al. 2008), whose bounds must be those of this surface (surface_bounds.hpp), and
/// tests cells by cell_crossing.hpp. All arithmetic is in double and shares nothing with the SIMD tracer, whose reference it
/// is. A ray that begins below the surface hits it from below; so does one that enters below the surface through the border or
/// from a cell without a surface.
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
