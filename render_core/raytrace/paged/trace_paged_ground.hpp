/// Traces pictures of a view in world space, over ground that need not be in memory; the hits are those of trace_ground().
///
/// The straight pieces of all tiles' rays are traced one after another, each for the rays without a hit.
///
/// Memory  the caller's, and the tracer's. Thread  uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/raytrace/paged/paged_tracer.hpp"
#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::raytrace {

/// `space` is that of the tracer's window, and can_trace() must hold. `from_below` is as in PagedTracer::trace(). `cameras` is
/// scratch memory, one for each of ViewTiles(view.width, view.height). Writes one hit per pixel, with t as in trace_ground(), and
/// `cells` as PagedTracer::trace() does.
template <class Height>
PagedWork trace_paged_ground(PagedTracer<Height>& tracer, const GroundSpace& space, const terrain::View& view,
                             CellSurface surface, bool from_below, const PacketKernel<Height>& kernel, base::Workers& workers,
                             base::Span<GridCamera> cameras, base::Span<Hit> hits, base::Span<HitCell<Height>> cells = {});

}  // namespace tedavis::raytrace
