#include "render_core/raytrace/picture/kernel_terrain.hpp"

#include <algorithm>

#include "render_core/raytrace/picture/span_cells.hpp"
#include "render_core/raytrace/picture/wide_loops.hpp"
#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kMaxInSpan = PixelSpan::kMax;

/// Where the cells of a span are in the grid.
struct SpanPlaces {
    std::uint32_t post[kMaxInSpan];  ///< row * cells + column
    std::int32_t row[kMaxInSpan];
};

/// A ray that meets nothing leaves no place: it counts as the cell's corner, so that nothing made of it is out of range.
TEDAVIS_WIDE_LOOPS void read_places(const std::int32_t* __restrict cell, const float* __restrict u, const float* __restrict v,
                                    std::uint32_t count, SpanCells& __restrict read) {
    for (std::uint32_t n = 0; n < count; ++n) {
        read.u[n] = cell[n] >= 0 ? u[n] : 0;
        read.v[n] = cell[n] >= 0 ? v[n] : 0;
    }
}

/// Rows of cells by a multiplication: with half a cell added it is right for every number of 31 bits.
TEDAVIS_WIDE_LOOPS void find_places(const std::int32_t* __restrict cell, std::int32_t across, double part,
                                    const SpanCells& __restrict cells, SpanSurface& __restrict out,
                                    SpanPlaces& __restrict found) {
    const double cells_part = 1.0 / across;
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) out.is_hit[n] = cell[n] >= 0;
    for (std::uint32_t n = 0; n < count; ++n) {
        const std::int32_t place = std::max(cell[n], 0);
        const auto row = static_cast<std::int32_t>((place + 0.5) * cells_part);
        const std::int32_t column = place - row * across;
        out.x[n] = (column + double{cells.u[n]}) * part;
        out.y[n] = (row + double{cells.v[n]}) * part;
        found.row[n] = row;
        found.post[n] = static_cast<std::uint32_t>(place);
    }
}

template <class Height>
void find_corners(const HeightGrid<Height>& grid, std::uint32_t count, const SpanPlaces& __restrict places,
                  SpanCells& __restrict cells) {
    const std::size_t stride = grid.stride, skipped = stride - (grid.columns - 1);
    for (std::uint32_t n = 0; n < count; ++n) {
        const Height* const post = grid.posts + places.post[n] + static_cast<std::size_t>(places.row[n]) * skipped;
        cells.corner[0][n] = static_cast<float>(post[0]);
        cells.corner[1][n] = static_cast<float>(post[1]);
        cells.corner[2][n] = static_cast<float>(post[stride]);
        cells.corner[3][n] = static_cast<float>(post[stride + 1]);
    }
}

}  // namespace

template <class Height>
void KernelTerrain<Height>::start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width,
                                  std::uint32_t height) {
    TEDAVIS_CHECK(parts > 0 && width > 0 && height > 0);
    field_ = field;
    parts_ = parts;
    width_ = width;
    height_ = height;
}

template <class Height>
void KernelTerrain<Height>::set_view(const PictureSight& sight, const ViewKernel<Height>& kernel) {
    sight_ = sight.refined(parts_);
    kernel_ = &kernel;
    if (!sight_.is_of_world()) return;
    TEDAVIS_CHECK(sight_.view.width == width_ && sight_.view.height == height_);
    ground_ = GroundView<Height>(field_, sight_.space, sight_.view, kernel);
}

template <class Height>
void KernelTerrain<Height>::trace(const PixelRect& rect, const HitPicture& hits) const {
    const std::uint32_t right = rect.x + rect.width, bottom = rect.y + rect.height;
    const auto is_whole = [](std::uint32_t from, std::uint32_t to, std::uint32_t step, std::uint32_t end) {
        return from % step == 0 && (to % step == 0 || to == end);
    };
    TEDAVIS_CHECK(is_whole(rect.x, right, kTileWidth, width_) && is_whole(rect.y, bottom, kTileHeight, height_));
    if (!is_in_reach(sight_.camera.origin)) return clear_pixels(hits, width_, rect.x, rect.y, right, bottom);
    const ViewJob<Height> job = {&field_, &sight_.camera, width_, height_, hits, {}, false};
    for (std::uint32_t y = rect.y; y < bottom; y += kTileHeight)
        for (std::uint32_t x = rect.x; x < right; x += kTileWidth)
            if (sight_.is_of_world())
                trace_ground_tile(ground_, x, y, hits);
            else
                kernel_->trace_tile(job, x, y);
}

template <class Height>
void KernelTerrain<Height>::find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const {
    TEDAVIS_CHECK(span.count <= PixelSpan::kMax && std::size_t{span.first} + span.count <= hits.t.size());
    surface.count = span.count;
    std::copy_n(hits.t.data() + span.first, span.count, surface.t);
    const HeightGrid<Height>& grid = field_.grid();
    SpanCells cells;
    SpanPlaces places;
    const std::int32_t* const cell = hits.cell.data() + span.first;
    read_places(cell, hits.u.data() + span.first, hits.v.data() + span.first, span.count, cells);
    find_places(cell, static_cast<std::int32_t>(grid.columns - 1), 1.0 / parts_, cells, surface, places);
    find_corners(grid, span.count, places, cells);
    find_cell_surface(cells, field_.surface, static_cast<float>(parts_), surface);
}

template <class Height>
Ray KernelTerrain<Height>::own_ray(const Ray& ray) const {
    Ray own = ray;
    own.origin.x *= parts_;
    own.origin.y *= parts_;
    own.direction.x *= static_cast<float>(parts_);
    own.direction.y *= static_cast<float>(parts_);
    return own;
}

template <class Height>
typename KernelTerrain<Height>::PlacedHit KernelTerrain<Height>::hit_of(const Ray& straight) const {
    const Hit hit = trace_ray(field_, straight);
    if (hit.side == HitSide::none) return {};
    const glm::dvec3 place = straight.origin + static_cast<double>(hit.t) * glm::dvec3(straight.direction);
    return {hit.side,
            hit.t,
            hit.column,
            hit.row,
            std::clamp(place.x - hit.column, 0.0, 1.0),
            std::clamp(place.y - hit.row, 0.0, 1.0)};
}

template <class Height>
typename KernelTerrain<Height>::PlacedHit KernelTerrain<Height>::first_hit(const Ray& ray) const {
    const Ray own = own_ray(ray);
    if (!sight_.is_of_world()) return hit_of(own);
    return trace_bent(sight_.space, own, ground_.highest, [this](const Ray& piece) { return hit_of(piece); });
}

template <class Height>
RayHit KernelTerrain<Height>::intersect(const Ray& ray) const {
    const PlacedHit hit = first_hit(ray);
    RayHit ray_hit;
    ray_hit.is_hit = hit.side != HitSide::none;
    if (!ray_hit.is_hit) return ray_hit;
    SurfaceSettings settings;
    settings.kind = field_.surface == CellSurface::bilinear ? SurfaceKind::bilinear : SurfaceKind::two_triangles;
    ray_hit.point = cell_patch(field_.grid(), settings, hit.column, hit.row).at(hit.u, hit.v);
    ray_hit.point.slope_x *= parts_;
    ray_hit.point.slope_y *= parts_;
    ray_hit.t = hit.t;
    ray_hit.x = (hit.column + hit.u) / parts_;
    ray_hit.y = (hit.row + hit.v) / parts_;
    return ray_hit;
}

template <class Height>
bool KernelTerrain<Height>::is_hidden(const Ray& ray) const {
    return first_hit(ray).side != HitSide::none;
}

template class KernelTerrain<std::int16_t>;
template class KernelTerrain<float>;

}  // namespace tedavis::raytrace
