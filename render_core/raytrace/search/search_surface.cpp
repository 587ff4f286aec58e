#include "render_core/raytrace/search/search_surface.hpp"

#include "render_core/raytrace/search/walk_nodes.hpp"

namespace tedavis::raytrace {
namespace {

SurfaceHit searched_hit(const SearchedPlace& found, const CellPlace& place, const SurfacePoint& point) {
    return {found.is_from_below ? HitSide::below : HitSide::above, found.t, place, point.height, {point.slope_x, point.slope_y}};
}

template <class Height>
SurfaceHit search_cell(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const NodeWalk& walk,
                       const UniformSearch& search) {
    const CellPatch patch = cell_patch(maxima.grid(), settings, walk.column(), walk.row());
    if (!patch.has_surface) return {};
    const CellRay ray = walk.in_cell();
    const auto gap = [&](double s) {
        const RayPoint point = s <= 0 ? ray.from : (s >= 1 ? ray.to : ray.at(s));
        return point.z - surface_on(patch, settings.micro, point.place).height;
    };
    SearchedPlace found = search_uniformly(gap, 0, 1, search);
    if (!found.is_hit) return {};
    const RayPoint point = ray.at(found.t);
    found.t = point.t;
    return searched_hit(found, point.place, surface_on(patch, settings.micro, point.place));
}

}  // namespace

template <class Height>
SurfaceHit search_cells(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const Ray& ray,
                        const UniformSearch& search, TraceCounts* counts) {
    TraceCounts ignored;
    return walk_nodes(maxima, ray, counts != nullptr ? *counts : ignored,
                      [&](const NodeWalk& walk) { return search_cell(maxima, settings, walk, search); });
}

template <class Height>
SurfaceHit search_ray(const HeightGrid<Height>& grid, const SurfaceSettings& settings, const Ray& ray,
                      const UniformSearch& search) {
    NodeWalk walk(ray, grid.columns - 1, grid.rows - 1);
    if (!walk.is_inside()) return {};
    constexpr std::uint32_t kWhole = 31;  // a level whose one node is the grid
    const auto place_at = [&](double t) { return ray.origin + t * glm::dvec3(ray.direction); };
    const auto gap = [&](double t) {
        const glm::dvec3 place = place_at(t);
        SurfacePoint point;
        return find_surface(grid, settings, place.x, place.y, point) ? place.z - point.height
                                                                     : std::numeric_limits<double>::quiet_NaN();
    };
    const SearchedPlace found = search_uniformly(gap, walk.t(), walk.exit_t(kWhole), search);
    CellPlace cell;
    SurfacePoint point;
    const glm::dvec3 place = place_at(found.t);
    if (!found.is_hit || !find_cell(grid, place.x, place.y, cell) || !find_surface(grid, settings, place.x, place.y, point))
        return {};
    return searched_hit(found, cell, point);
}

template SurfaceHit search_cells(const HeightMipmap<std::int16_t>&, const SurfaceSettings&, const Ray&, const UniformSearch&,
                                 TraceCounts*);
template SurfaceHit search_cells(const HeightMipmap<float>&, const SurfaceSettings&, const Ray&, const UniformSearch&,
                                 TraceCounts*);
template SurfaceHit search_ray(const HeightGrid<std::int16_t>&, const SurfaceSettings&, const Ray&, const UniformSearch&);
template SurfaceHit search_ray(const HeightGrid<float>&, const SurfaceSettings&, const Ray&, const UniformSearch&);

}  // namespace tedavis::raytrace
