/// Pictures of the ground as a view of the world sees it, over ground that need not be in memory: what trace_ground() finds.
///
/// Piece after piece of the rays of all tiles, each with those that have met nothing yet.
///
/// Memory  the caller's, and the tracer's. Thread  uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/raytrace/paged/paged_tracer.hpp"
#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::raytrace {

/// `space`: of the window that the tracer's heights are; can_trace() holds. `from_below` as in PagedTracer::trace(). The cameras
/// are room to work in, one for each of ViewTiles(view.width, view.height); a hit a pixel, t as trace_ground() has it.
template <class Height>
PagedWork trace_paged_ground(PagedTracer<Height>& tracer, const GroundSpace& space, const terrain::View& view,
                             CellSurface surface, bool from_below, const PacketKernel<Height>& kernel, base::Workers& workers,
                             base::Span<GridCamera> cameras, base::Span<Hit> hits);

}  // namespace tedavis::raytrace
