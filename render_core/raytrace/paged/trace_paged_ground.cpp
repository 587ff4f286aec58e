#include "render_core/raytrace/paged/trace_paged_ground.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

struct CameraWork {
    const GroundSpace& space;
    const terrain::View& view;
    const base::Span<GridCamera> cameras;
    const ViewTiles tiles;
    double from = 0, to = 0;

    static void fit(void* context, std::uint32_t tile) {
        const auto& all = *static_cast<const CameraWork*>(context);
        const std::uint32_t left = all.tiles.left(tile), top = all.tiles.top(tile);
        const PixelTile pixels{left, top, std::min(left + kTileWidth, all.view.width),
                               std::min(top + kTileHeight, all.view.height)};
        all.cameras[tile] = fit_camera(all.space, all.view, pixels, all.from, all.to);
    }
};

void add_work(const PagedWork& piece, PagedWork& all) {
    all.passes += piece.passes;
    all.loads += piece.loads;
    all.damaged += piece.damaged;
    all.crossings += piece.crossings;
    all.loaded_bytes += piece.loaded_bytes;
}

}  // namespace

template <class Height>
PagedWork trace_paged_ground(PagedTracer<Height>& tracer, const GroundSpace& space, const terrain::View& view,
                             CellSurface surface, bool from_below, const PacketKernel<Height>& kernel, base::Workers& workers,
                             base::Span<GridCamera> cameras, base::Span<Hit> hits, base::Span<HitCell<Height>> cells) {
    CameraWork work{space, view, cameras, ViewTiles(view.width, view.height)};
    TEDAVIS_CHECK(can_trace(space, view) && cameras.size() == work.tiles.count());
    const PieceEnds ends = cut_view(view);
    PagedRays rays;
    rays.cameras = cameras;
    rays.width = view.width;
    rays.height = view.height;
    PagedWork all;
    for (int piece = 0; piece < ends.count; ++piece) {
        work.from = ends.end[piece];
        work.to = ends.end[piece + 1];
        workers.parallel_for(work.tiles.count(), CameraWork::fit, &work);
        const double gap = gap_before(space, view, work.from);
        rays.span = {static_cast<float>(work.from), static_cast<float>(work.to), static_cast<float>(gap)};
        rays.goes_on = piece > 0;
        add_work(tracer.trace(rays, surface, from_below, kernel, workers, hits, cells), all);
    }
    return all;
}

template PagedWork trace_paged_ground(PagedTracer<std::int16_t>&, const GroundSpace&, const terrain::View&, CellSurface, bool,
                                      const PacketKernel<std::int16_t>&, base::Workers&, base::Span<GridCamera>, base::Span<Hit>,
                                      base::Span<HitCell<std::int16_t>>);
template PagedWork trace_paged_ground(PagedTracer<float>&, const GroundSpace&, const terrain::View&, CellSurface, bool,
                                      const PacketKernel<float>&, base::Workers&, base::Span<GridCamera>, base::Span<Hit>,
                                      base::Span<HitCell<float>>);

}  // namespace tedavis::raytrace
