/// Traverses the cells of one chunk, or the grid from chunk to chunk, with the rays of a packet.
///
/// A chunk is treated as a small grid whose first cell has the number 0, and the cells of the rays' origins are renumbered to
/// match. The times at which a ray crosses grid lines are computed from the distance to its origin's cell, which does not change
/// by this. Hits are therefore equal, bit for bit, to those of a traversal of the whole grid.
#pragma once

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/paged/chunk_bounds.hpp"
#include "render_core/raytrace/paged/ray_packet.hpp"

namespace tedavis::raytrace {

/// Returns the rays of the packet with cells numbered from (first_column, first_row) of the grid.
template <class V>
TEDAVIS_LANES_INLINE RayLanes<V> packet_rays(const RayPacket& p, std::int32_t first_column, std::int32_t first_row) {
    using Int = typename V::Int;
    RayLanes<V> ray;
    ray.x = RayAxis<V>::make(V::load(p.column) - Int(first_column), V::load(p.column_fraction), V::load(p.direction_x));
    ray.y = RayAxis<V>::make(V::load(p.row) - Int(first_row), V::load(p.row_fraction), V::load(p.direction_y));
    ray.z = V::load(p.z);
    ray.z_fraction = V::load(p.z_fraction);
    ray.climb = V::load(p.direction_z);
    ray.from = V::load(p.from);
    ray.to = V::load(p.to);
    ray.gap = V::load(p.gap);
    return ray;
}

/// PacketKernel::cross for one surface and side.
template <class V, class Height, CellSurface surface, HitSide side>
void cross_chunk(const TracedNodes<Height>& nodes, std::int32_t column, std::int32_t row, std::uint32_t asked, RayPacket& p) {
    using Int = typename V::Int;
    const RayLanes<V> ray = packet_rays<V>(p, column, row);
    TraversalState<V> m = enter<V, Height>(nodes, ray, ray.from, V::mask(asked), Int(nodes.layout->top));
    march_nodes<V, Height, surface, side>(nodes, ray, m);
    p.hit |= V::bits(m.is_hit) & asked;
    p.beyond |= V::bits(m.is_beyond) & asked;
    V::store(p.hit_t, V::select(m.is_hit, m.hit_t, V::load(p.hit_t)));
    V::store(p.hit_column, V::select(m.is_hit, m.hit_column + Int(column), V::load(p.hit_column)));
    V::store(p.hit_row, V::select(m.is_hit, m.hit_row + Int(row), V::load(p.hit_row)));
}

/// PacketKernel::seek for one side.
template <class V, class Height, HitSide side>
void seek_chunk(const TracedNodes<Height>& nodes, std::uint32_t asked, RayPacket& p) {
    using Int = typename V::Int;
    using Mask = typename V::Mask;
    const RayLanes<V> ray = packet_rays<V>(p, 0, 0);
    TraversalState<V> m = enter<V, Height>(nodes, ray, ray.from, V::mask(asked), Int(nodes.layout->top));
    const Mask passes = V::mask(asked & p.pass);
    m.t = V::select(passes, V::load(p.t), m.t);
    m.column = V::select(passes, V::load(p.at_column), m.column);
    m.row = V::select(passes, V::load(p.at_row), m.row);
    m.level = V::select(passes, Int(kChunkLevel), m.level);
    m.passes = m.runs & passes;
    for (Mask steps = m.runs; V::any(steps); steps = V::without(m.runs, m.asks))
        step_node<V, Height, side, kChunkLevel>(nodes, ray, m, steps);
    const Mask asks = m.asks;
    p.ask |= V::bits(asks) & asked;
    V::store(p.t, V::select(asks, m.t, V::load(p.t)));
    V::store(p.at_column, V::select(asks, m.column, V::load(p.at_column)));
    V::store(p.at_row, V::select(asks, m.row, V::load(p.at_row)));
    V::store(p.chunk_column, V::select(asks, (m.column ^ ray.x.sign) >> Int(kChunkLevel), V::load(p.chunk_column)));
    V::store(p.chunk_row, V::select(asks, (m.row ^ ray.y.sign) >> Int(kChunkLevel), V::load(p.chunk_row)));
}

template <class V, class Height>
void cross_with(const TracedNodes<Height>& nodes, CellSurface surface, HitSide side, std::int32_t column, std::int32_t row,
                std::uint32_t asked, RayPacket& p) {
    constexpr CellSurface kTriangles = CellSurface::two_triangles, kPatch = CellSurface::bilinear;
    if (surface == kTriangles && side == HitSide::above)
        cross_chunk<V, Height, kTriangles, HitSide::above>(nodes, column, row, asked, p);
    else if (surface == kTriangles)
        cross_chunk<V, Height, kTriangles, HitSide::below>(nodes, column, row, asked, p);
    else if (side == HitSide::above)
        cross_chunk<V, Height, kPatch, HitSide::above>(nodes, column, row, asked, p);
    else
        cross_chunk<V, Height, kPatch, HitSide::below>(nodes, column, row, asked, p);
}

template <class V, class Height>
void seek_with(const TracedNodes<Height>& nodes, HitSide side, std::uint32_t asked, RayPacket& p) {
    if (side == HitSide::above)
        seek_chunk<V, Height, HitSide::above>(nodes, asked, p);
    else
        seek_chunk<V, Height, HitSide::below>(nodes, asked, p);
}

}  // namespace tedavis::raytrace
