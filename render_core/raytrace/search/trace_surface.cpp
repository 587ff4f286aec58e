#include "render_core/raytrace/search/trace_surface.hpp"

#include <initializer_list>

#include "render_core/raytrace/search/cell_crossing.hpp"
#include "render_core/raytrace/search/walk_nodes.hpp"

namespace tedavis::raytrace {
namespace {

/// The part of a stretch that is within the heights of a patch and a little beyond them, so that its ends keep their sides. A ray
/// straight down would else be mostly elsewhere.
CellRay within_heights(const CellRay& ray, const HeightRange& range) {
    CellRay part = ray;
    const auto cut_at = [&](double height) {
        RayPoint point = ray.at(std::clamp((ray.from.z - height) / (ray.from.z - ray.to.z), 0.0, 1.0));
        point.z = height;
        return point;
    };
    for (const double height : {range.lowest, range.highest}) {
        const bool is_lowest = height == range.lowest;
        const auto is_beyond = [&](double z) { return is_lowest ? z < height : z > height; };
        if (is_beyond(ray.from.z) == is_beyond(ray.to.z)) continue;
        (is_beyond(ray.from.z) ? part.from : part.to) = cut_at(height);
    }
    return part;
}

template <class Height>
SurfaceHit hit_in_cell(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const NodeWalk& walk) {
    SurfaceHit hit;
    const CellPatch patch = cell_patch(maxima.grid(), settings, walk.column(), walk.row());
    if (!patch.has_surface) return hit;
    const double amplitude = amplitude_of(settings.micro);
    HeightRange range = patch.range();
    const double beyond = amplitude + 0.01 * (range.highest - range.lowest) + 1e-3;
    range = {range.lowest - beyond, range.highest + beyond};
    const CellRay ray = within_heights(walk.in_cell(), range);
    const Crossing crossing = first_crossing(patch, settings.micro, ray);
    if (!crossing.is_hit) return hit;
    const RayPoint point = crossing.s <= 0 ? ray.from : (crossing.s >= 1 ? ray.to : ray.at(crossing.s));
    const SurfacePoint surface = surface_on(patch, settings.micro, point.place);
    hit.side = crossing.is_from_below ? HitSide::below : HitSide::above;
    hit.t = point.t;
    hit.place = point.place;
    hit.height = surface.height;
    hit.slopes = {surface.slope_x, surface.slope_y};
    return hit;
}

}  // namespace

template <class Height>
SurfaceHit trace_surface(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, const Ray& ray,
                         TraceCounts* counts) {
    TraceCounts ignored;
    return walk_nodes(maxima, ray, counts != nullptr ? *counts : ignored,
                      [&](const NodeWalk& walk) { return hit_in_cell(maxima, settings, walk); });
}

template SurfaceHit trace_surface(const HeightMipmap<std::int16_t>&, const SurfaceSettings&, const Ray&, TraceCounts*);
template SurfaceHit trace_surface(const HeightMipmap<float>&, const SurfaceSettings&, const Ray&, TraceCounts*);

}  // namespace tedavis::raytrace
