/// Incoherent rays of a tile: they leave their packets and continue in lanes that are refilled, so that no lane waits long for
/// another (as in Wald et al. 2007, "Compacting rays"). A ray's hit does not depend on the other lanes.
#pragma once

#include "render_core/raytrace/kernel/packet_pixels.hpp"
#include "render_core/raytrace/kernel/tile_work.hpp"

namespace tedavis::raytrace {

/// The rays of one tile: pixel, time reached, and mipmap level.
template <class V>
struct LooseRays {
    static constexpr std::uint32_t kMax = kTileWidth * kTileHeight;
    std::uint32_t count = 0;
    float x[kMax + V::kCount], y[kMax + V::kCount], t[kMax + V::kCount];  ///< pixels; whole vectors of lanes are read
    std::int32_t level[kMax + V::kCount];

    /// Fills the lanes behind the last waiting ray with copies of the first.
    void fill(std::uint32_t lanes) {
        for (; lanes < V::kCount; ++lanes) {
            x[count + lanes] = x[count];
            y[count + lanes] = y[count];
            t[count + lanes] = t[count];
            level[count + lanes] = level[count];
        }
    }
    void take(std::uint32_t lanes, typename V::Float at_x, typename V::Float at_y, typename V::Float at_t,
              typename V::Int at_level) {
        float lane_x[V::kCount], lane_y[V::kCount], lane_t[V::kCount];
        std::int32_t lane_level[V::kCount];
        V::store(lane_x, at_x);
        V::store(lane_y, at_y);
        V::store(lane_t, at_t);
        V::store(lane_level, at_level);
        for (; lanes != 0; lanes &= lanes - 1, ++count) {
            const int n = __builtin_ctz(lanes);
            x[count] = lane_x[n];
            y[count] = lane_y[n];
            t[count] = lane_t[n];
            level[count] = lane_level[n];
        }
    }
};

/// Traverses nodes as long as most of the lanes are active.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void march_nodes_together(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m,
                                               int few) {
    constexpr int kEnough = V::kCount * 3 / 8 + 1;  // rays that need a cell test before one is run, since it costs several steps
    while (V::any(m.runs)) {
        const auto steps = V::without(m.runs, m.asks);
        if (!V::any(steps) || __builtin_popcount(V::bits(m.asks)) >= kEnough) {
            intersect_cells<V, Height, surface, HitSide::above>(field, ray, m);
            continue;
        }
        step_node<V, Height, HitSide::above>(field, ray, m, steps);
        if (!V::any(m.passes) && __builtin_popcount(V::bits(m.runs)) <= few) return;
    }
}

/// Writes the hits of lanes to arbitrary pixels of the picture.
template <class V, class Height>
void keep_scattered(const TileWork<V, Height>& tile, const RayLanes<V>& ray, const TraversalState<V>& m, const float* x,
                    const float* y, std::uint32_t lanes) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const HitPicture& picture = tile.job.picture;
    const auto done = V::mask(lanes);
    const Int column = V::floor_to_int(V::load(x)), row = V::floor_to_int(V::load(y));
    const Int to = row * Int(static_cast<std::int32_t>(tile.job.width)) + column;
    const Int cell = V::select(m.is_hit, m.hit_row * Int(tile.nodes.columns) + m.hit_column, Int(HitPicture::kNoCell));
    V::scatter(picture.t.data(), to, V::select(m.is_hit, m.hit_t, Float(__builtin_inff())), done);
    if (!picture.cell.empty()) V::scatter(picture.cell.data(), to, cell, done);
    if (!picture.u.empty()) {
        V::scatter(picture.u.data(), to, RayAxis<V>::place_in(ray.x, m.hit_column, m.hit_t), done);
        V::scatter(picture.v.data(), to, RayAxis<V>::place_in(ray.y, m.hit_row, m.hit_t), done);
    }
    const std::uint32_t hit = V::bits(m.is_hit), beyond = V::bits(m.is_beyond);
    for (; lanes != 0; lanes &= lanes - 1) {
        const int n = __builtin_ctz(lanes);
        const auto pixel_x = static_cast<std::uint32_t>(x[n]), pixel_y = static_cast<std::uint32_t>(y[n]);
        if (!picture.side.empty())
            picture.side[std::size_t{pixel_y} * tile.job.width + pixel_x] = (hit >> n & 1) != 0 ? HitSide::above : HitSide::none;
        if ((beyond >> n & 1) != 0) trace_pixel(tile.job, pixel_x, pixel_y);
    }
}

template <class V, class Height, CellSurface surface>
void trace_loose(const TileWork<V, Height>& tile, LooseRays<V>& loose) {
    constexpr int kFew = V::kCount / 2;
    while (loose.count > 0) {
        const std::uint32_t lanes = loose.count < V::kCount ? loose.count : V::kCount;
        loose.count -= lanes;
        loose.fill(lanes);
        const std::uint32_t all = lanes == 32 ? ~0u : (1u << lanes) - 1;
        float x[V::kCount], y[V::kCount];
        const auto at_x = V::load(loose.x + loose.count), at_y = V::load(loose.y + loose.count);
        V::store(x, at_x);
        V::store(y, at_y);
        const RayLanes<V> ray = tile.rays(at_x, at_y);
        TraversalState<V> m =
            enter<V, Height>(tile.nodes, ray, V::load(loose.t + loose.count), V::mask(all), V::load(loose.level + loose.count));
        march_nodes_together<V, Height, surface>(tile.nodes, ray, m, loose.count > 0 ? kFew : 0);
        const std::uint32_t runs = V::bits(m.runs);
        keep_scattered<V, Height>(tile, ray, m, x, y, all & ~runs);
        if (runs != 0) loose.take(runs, at_x, at_y, m.t, m.level);
    }
}

}  // namespace tedavis::raytrace
