#include "render_core/raytrace/picture/paged_terrain.hpp"

#include <algorithm>

#include "render_core/raytrace/picture/span_cells.hpp"

namespace tedavis::raytrace {

std::uint64_t PagedTerrain::bytes_needed(std::uint32_t width, std::uint32_t height) {
    return std::uint64_t{width} * height * (sizeof(Hit) + sizeof(HitCell<float>)) +
           ViewTiles(width, height).count() * sizeof(GridCamera) + 64;
}

bool PagedTerrain::start(PagedTracer<float>& tracer, CellSurface surface, std::uint32_t width, std::uint32_t height,
                         base::Arena& arena) {
    TEDAVIS_CHECK(width > 0 && height > 0);
    tracer_ = &tracer;
    surface_ = surface;
    width_ = width;
    height_ = height;
    const std::size_t pixels = std::size_t{width} * height;
    cameras_ = arena.allocate_array<GridCamera>(ViewTiles(width, height).count());
    hits_ = arena.allocate_array<Hit>(pixels);
    cells_ = arena.allocate_array<HitCell<float>>(pixels);
    return !cameras_.empty() && !hits_.empty() && !cells_.empty();
}

PagedWork PagedTerrain::trace_picture(const PictureSight& sight, const PacketKernel<float>& kernel, base::Workers& workers) {
    TEDAVIS_CHECK(sight.is_of_world() && sight.view.width == width_ && sight.view.height == height_);
    // From above alone, as the terrain in memory is traced.
    return trace_paged_ground(*tracer_, sight.space, sight.view, surface_, false, kernel, workers, cameras_, hits_, cells_);
}

void PagedTerrain::trace(const PixelRect& rect, const HitPicture& hits) const {
    for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y)
        for (std::uint32_t x = rect.x; x < rect.x + rect.width; ++x) {
            const std::size_t pixel = std::size_t{y} * width_ + x;
            const Hit& hit = hits_[pixel];
            hits.t[pixel] = hit.t;
            hits.side[pixel] = hit.side;
            hits.cell[pixel] = hit.side == HitSide::none ? HitPicture::kNoCell : 0;
            if (hit.side == HitSide::none) continue;
            hits.u[pixel] = cells_[pixel].place.u;
            hits.v[pixel] = cells_[pixel].place.v;
        }
}

void PagedTerrain::find_surface(const PixelSpan& span, const HitPicture&, SpanSurface& surface) const {
    TEDAVIS_CHECK(span.count <= PixelSpan::kMax && std::size_t{span.first} + span.count <= hits_.size());
    surface.count = span.count;
    SpanCells cells;
    for (std::uint32_t n = 0; n < span.count; ++n) {
        const Hit& hit = hits_[span.first + n];
        const bool is_hit = hit.side != HitSide::none;
        const HitCell<float> cell = is_hit ? cells_[span.first + n] : HitCell<float>{};
        surface.is_hit[n] = is_hit;
        surface.t[n] = hit.t;
        surface.x[n] = hit.column + double{cell.place.u};
        surface.y[n] = hit.row + double{cell.place.v};
        cells.u[n] = cell.place.u;
        cells.v[n] = cell.place.v;
        for (int k = 0; k < 4; ++k) cells.corner[k][n] = cell.corner[k];
    }
    find_cell_surface(cells, surface_, 1, surface);
}

RayHit PagedTerrain::intersect(const Ray&) const {
    TEDAVIS_CHECK(false);
    return {};
}

bool PagedTerrain::is_hidden(const Ray&) const {
    TEDAVIS_CHECK(false);
    return false;
}

}  // namespace tedavis::raytrace
