#include "render_core/raytrace/picture/smooth_terrain.hpp"

#include <cmath>

#include "render_core/raytrace/search/node_walk.hpp"
#include "render_core/raytrace/search/search_surface.hpp"
#include "render_core/raytrace/search/trace_surface.hpp"

namespace tedavis::raytrace {

template <class Height>
void SmoothTerrain<Height>::start(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, std::uint32_t width) {
    maxima_ = &maxima;
    settings_ = &settings;
    width_ = width;
    search_ = {};
    cones_ = nullptr;
}

template <class Height>
void SmoothTerrain<Height>::set_search(const SearchSettings& search, const ConeMap<Height>* cones) {
    TEDAVIS_CHECK(search.kind != SearchKind::cones || cones != nullptr);
    search_ = search;
    cones_ = cones;
}

template <class Height>
void SmoothTerrain<Height>::set_view(const PictureSight& sight) {
    sight_ = sight;
    const MipmapLayout& layout = maxima_->layout();
    highest_ = static_cast<double>(maxima_->level(static_cast<std::uint32_t>(layout.top)).nodes[0]);
}

/// The length of a straight ray over the grid, in its t.
template <class Height>
double SmoothTerrain<Height>::way_over_grid(const Ray& straight) const {
    constexpr std::uint32_t kWhole = 31;  // a level whose one node is the grid
    const NodeWalk walk(straight, maxima_->grid().columns - 1, maxima_->grid().rows - 1);
    return walk.is_inside() ? walk.exit_t(kWhole) - walk.t() : 0;
}

/// The same of all straight pieces of a ray of the world.
template <class Height>
double SmoothTerrain<Height>::whole_way(const Ray& ray) const {
    double whole = 0;
    static_cast<void>(trace_bent(sight_.space, ray, highest_, [&](const Ray& piece) {
        whole += way_over_grid(piece);
        return SurfaceHit{};
    }));
    return whole;
}

/// `whole` is the length that the steps of a search over the ray are shared by; unused by the other searches.
template <class Height>
SurfaceHit SmoothTerrain<Height>::searched(const Ray& straight, double whole) const {
    switch (search_.kind) {
        case SearchKind::exact: break;
        case SearchKind::cells: return search_cells(*maxima_, *settings_, straight, search_.uniform());
        case SearchKind::cones: return cones_->search(straight, {search_.steps, search_.halvings});
        case SearchKind::ray: {
            const double share = whole > 0 ? way_over_grid(straight) / whole : 0;
            const auto steps = static_cast<std::uint32_t>(std::ceil(share * search_.steps));
            return search_ray(maxima_->grid(), *settings_, straight, {steps > 0 ? steps : 1, search_.halvings});
        }
    }
    return trace_surface(*maxima_, *settings_, straight);
}

/// Of a ray that begins a little below the surface only because its pieces do not meet exactly (Ray::gap), that is where it has
/// met it.
template <class Height>
SurfaceHit SmoothTerrain<Height>::hit_of(const Ray& straight, double whole) const {
    SurfaceHit hit = searched(straight, whole);
    if (straight.gap <= 0) return hit;
    const double from = static_cast<double>(straight.from);
    const glm::dvec3 begin = straight.origin + from * glm::dvec3(straight.direction);
    CellPlace place;
    if (!find_cell(maxima_->grid(), begin.x, begin.y, place)) return hit;
    const CellPatch patch = cell_patch(maxima_->grid(), *settings_, place.column, place.row);
    if (!patch.has_surface) return hit;
    const SurfacePoint point = surface_on(patch, settings_->micro, place);
    if (begin.z >= point.height || begin.z < point.height - static_cast<double>(straight.gap)) return hit;
    return {HitSide::above, from, place, point.height, {point.slope_x, point.slope_y}};
}

template <class Height>
SurfaceHit SmoothTerrain<Height>::first_hit(const Ray& ray) const {
    const bool is_shared = search_.kind == SearchKind::ray;
    if (!sight_.is_of_world()) return hit_of(ray, is_shared ? way_over_grid(ray) : 0);
    const double whole = is_shared ? whole_way(ray) : 0;
    return trace_bent(sight_.space, ray, highest_, [&](const Ray& piece) { return hit_of(piece, whole); });
}

template <class Height>
void SmoothTerrain<Height>::trace(const PixelRect& rect, const HitPicture& hits) const {
    const std::uint32_t cells = maxima_->grid().columns - 1;
    for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y)
        for (std::uint32_t x = rect.x; x < rect.x + rect.width; ++x) {
            const SurfaceHit hit = first_hit(sight_.camera.ray(x, y));
            const std::size_t at = std::size_t{y} * width_ + x;
            const bool is_hit = hit.side != HitSide::none;
            hits.t.data()[at] = static_cast<float>(hit.t);
            hits.side.data()[at] = hit.side;
            hits.cell.data()[at] =
                is_hit ? static_cast<std::int32_t>(hit.place.row * cells + hit.place.column) : HitPicture::kNoCell;
            hits.u.data()[at] = static_cast<float>(hit.place.u);
            hits.v.data()[at] = static_cast<float>(hit.place.v);
        }
}

template <class Height>
void SmoothTerrain<Height>::find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const {
    TEDAVIS_CHECK(span.count <= PixelSpan::kMax && std::size_t{span.first} + span.count <= hits.t.size());
    const std::uint32_t cells = maxima_->grid().columns - 1;
    surface.count = span.count;
    for (std::uint32_t n = 0; n < span.count; ++n) {
        const std::int32_t cell = hits.cell.data()[span.first + n];
        surface.is_hit[n] = cell >= 0;
        surface.x[n] = surface.y[n] = 0;
        surface.t[n] = surface.height[n] = surface.slope_x[n] = surface.slope_y[n] = 0;
        if (cell < 0) continue;
        CellPlace place;
        place.row = static_cast<std::uint32_t>(cell) / cells;
        place.column = static_cast<std::uint32_t>(cell) - place.row * cells;
        place.u = hits.u.data()[span.first + n];
        place.v = hits.v.data()[span.first + n];
        const CellPatch patch = cell_patch(maxima_->grid(), *settings_, place.column, place.row);
        const SurfacePoint point = surface_on(patch, settings_->micro, place);
        surface.x[n] = place.column + place.u;
        surface.y[n] = place.row + place.v;
        surface.t[n] = hits.t.data()[span.first + n];
        surface.height[n] = static_cast<float>(point.height);
        surface.slope_x[n] = static_cast<float>(point.slope_x);
        surface.slope_y[n] = static_cast<float>(point.slope_y);
    }
}

template <class Height>
RayHit SmoothTerrain<Height>::intersect(const Ray& ray) const {
    const SurfaceHit hit = first_hit(ray);
    RayHit ray_hit;
    ray_hit.is_hit = hit.side != HitSide::none;
    if (!ray_hit.is_hit) return ray_hit;
    ray_hit.t = static_cast<float>(hit.t);
    ray_hit.x = hit.place.column + hit.place.u;
    ray_hit.y = hit.place.row + hit.place.v;
    ray_hit.point = {hit.height, hit.slopes.x, hit.slopes.y};
    return ray_hit;
}

template <class Height>
bool SmoothTerrain<Height>::is_hidden(const Ray& ray) const {
    return first_hit(ray).side != HitSide::none;
}

template class SmoothTerrain<std::int16_t>;
template class SmoothTerrain<float>;

}  // namespace tedavis::raytrace
