#include "render_core/raytrace/trace_ray.hpp"

#include <cmath>

#include "render_core/raytrace/kernel/march.hpp"

namespace tedavis::raytrace {
namespace {

using Lane = ScalarLanes;
RayLanes<Lane> lanes_of(const Ray& ray) {
    const double column = std::floor(ray.origin.x), row = std::floor(ray.origin.y), z = std::floor(ray.origin.z);
    RayLanes<Lane> r;
    r.x = RayAxis<Lane>::make(static_cast<std::int32_t>(column), static_cast<float>(ray.origin.x - column), ray.direction.x);
    r.y = RayAxis<Lane>::make(static_cast<std::int32_t>(row), static_cast<float>(ray.origin.y - row), ray.direction.y);
    r.z = static_cast<std::int32_t>(z);
    r.z_fraction = static_cast<float>(ray.origin.z - z);
    r.climb = ray.direction.z;
    r.from = ray.from;
    r.to = ray.to;
    r.gap = ray.gap;
    return r;
}

template <class Height, CellSurface surface, HitSide side>
TraversalState<Lane> march_side(const HeightMipmap<Height>& bounds, const RayLanes<Lane>& ray) {
    const TracedNodes<Height> nodes(bounds);
    TraversalState<Lane> m = enter<Lane, Height>(nodes, ray, ray.from, true, nodes.layout->top);
    march_nodes<Lane, Height, surface, side>(nodes, ray, m);
    return m;
}

Hit hit_of(const TraversalState<Lane>& m, HitSide side) {
    Hit hit;
    if (!m.is_hit) return hit;
    hit.side = side;
    hit.t = m.hit_t;
    hit.column = static_cast<std::uint32_t>(m.hit_column);
    hit.row = static_cast<std::uint32_t>(m.hit_row);
    return hit;
}

/// A ray changes sides without a meeting where it comes in through the border, or leaves a cell without a surface.
template <class Height, CellSurface surface>
Hit trace_sides(const TracedField<Height>& field, const Ray& ray) {
    RayLanes<Lane> lanes = lanes_of(ray);
    const std::uint64_t most = std::uint64_t{field.grid().columns} + field.grid().rows;
    for (std::uint64_t n = 0; n < most; ++n) {
        TraversalState<Lane> m = march_side<Height, surface, HitSide::above>(*field.maxima, lanes);
        if (!m.is_beyond) return hit_of(m, HitSide::above);
        if (field.minima == nullptr) return {};
        lanes.from = m.hit_t;
        m = march_side<Height, surface, HitSide::below>(*field.minima, lanes);
        if (!m.is_beyond) return hit_of(m, HitSide::below);
        lanes.from = m.hit_t;
    }
    return {};
}

}  // namespace

template <class Height>
Hit trace_ray(const TracedField<Height>& field, const Ray& ray) {
    if (!is_in_reach(ray.origin)) return {};
    return field.surface == CellSurface::two_triangles ? trace_sides<Height, CellSurface::two_triangles>(field, ray)
                                                       : trace_sides<Height, CellSurface::bilinear>(field, ray);
}

template Hit trace_ray(const TracedField<std::int16_t>&, const Ray&);
template Hit trace_ray(const TracedField<float>&, const Ray&);

}  // namespace tedavis::raytrace
