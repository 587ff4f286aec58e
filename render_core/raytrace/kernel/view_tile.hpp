/// A tile of a picture in lanes: its beams, from large to small, and then its rays.
#pragma once

#include "render_core/raytrace/kernel/beam_march.hpp"
#include "render_core/raytrace/kernel/column_sweep.hpp"
#include "render_core/raytrace/kernel/march_together.hpp"
#include "render_core/raytrace/kernel/packet_pixels.hpp"

namespace tedavis::raytrace {

/// Sides of beams, in pixels: kBeamSide[0] is found first, each further one starts where the one round it ended.
inline constexpr int kBeamSizes = 4;
inline constexpr std::uint32_t kBeamSide[kBeamSizes] = {32, 16, 8, 4};
/// Steps after which beams of each size are left where they are: those of their rays that get on do so alone.
inline constexpr int kMostBeamSteps[kBeamSizes] = {100, 100, 20, 12};
static_assert(kBeamSide[0] == kTileWidth && kBeamSide[0] == kTileHeight);
inline constexpr int kMostCells = 16;  ///< that rays pass one by one before they look at larger nodes

/// How far beams of one size got, row by row.
struct BeamStarts {
    static constexpr std::uint32_t kMost = kTileWidth / 4 * (kTileHeight / 4);
    float t[kMost];
    std::int32_t level[kMost];  ///< of nodes that they were over last
};

template <class V, class Height>
struct TileWork {
    const ViewJob<Height>& job;
    const TracedNodes<Height> nodes;
    const ViewOrigin origin;
    const ViewSlopes slopes;
    const std::uint32_t left, top;

    TileWork(const ViewJob<Height>& asked, std::uint32_t x, std::uint32_t y)
        : job(asked),
          nodes(*asked.field->maxima),
          origin(ViewOrigin::of(asked.camera->origin)),
          slopes(*asked.camera),
          left(x),
          top(y) {}
};

/// Beams of one size; `around` are those of the size before, null for the first.
template <class V, class Height>
void start_beams(const TileWork<V, Height>& tile, int size, const BeamStarts* around, BeamStarts& beams) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const std::uint32_t side = kBeamSide[size], across = kTileWidth / side, count = across * (kTileHeight / side);
    const float half = 0.5f * static_cast<float>(side);
    for (std::uint32_t first = 0; first < count; first += V::kCount) {
        float x[V::kCount], y[V::kCount], t[V::kCount];
        std::int32_t level[V::kCount];
        for (std::uint32_t n = 0; n < V::kCount; ++n) {
            const std::uint32_t at = first + n < count ? first + n : count - 1, column = at % across, row = at / across;
            x[n] = static_cast<float>(tile.left + column * side) + half;
            y[n] = static_cast<float>(tile.top + row * side) + half;
            const std::uint32_t parent = row / 2 * (across / 2) + column / 2;
            t[n] = around == nullptr ? tile.job.span.from : around->t[parent];
            level[n] = around == nullptr ? tile.nodes.layout->top : around->level[parent];
        }
        const Float at_x = V::load(x), at_y = V::load(y);
        const auto axis = [&](const DirectionSlope& slope) TEDAVIS_LANES_LAMBDA {
            return BeamAxis<V>::make(DirectionSlope::at<V>(slope, at_x, at_y), Float(DirectionSlope::reach(slope, half)));
        };
        BeamLanes<V> b;
        b.x = axis(tile.slopes.x);
        b.y = axis(tile.slopes.y);
        b.least_climb = axis(tile.slopes.z).least;
        b.column = Int(tile.origin.column);
        b.row = Int(tile.origin.row);
        b.z = Int(tile.origin.z);
        b.column_fraction = Float(tile.origin.column_fraction);
        b.row_fraction = Float(tile.origin.row_fraction);
        b.z_fraction = Float(tile.origin.z_fraction);
        b.to = Float(tile.job.span.to);
        b.t = V::load(t);
        b.level = V::load(level);
        march_beams<V, Height>(tile.nodes, b, kMostBeamSteps[size]);
        V::store(t, b.t);
        V::store(level, b.level);
        for (std::uint32_t n = 0; n < V::kCount && first + n < count; ++n) {
            beams.t[first + n] = t[n];
            beams.level[first + n] = level[n];
        }
    }
}

/// As far as the rays keep together.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void march_near(const TracedNodes<Height>& nodes, const RayLanes<V>& ray, const ViewOrigin& origin,
                                     March<V>& m) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    if (!NarrowAxis::is_one_way<V>(ray.x) || !NarrowAxis::is_one_way<V>(ray.y)) return;
    const NarrowAxis x = NarrowAxis::make(V::any(ray.x.sign < Int(0)), origin.column, origin.column_fraction, nodes.columns);
    const NarrowAxis y = NarrowAxis::make(V::any(ray.y.sign < Int(0)), origin.row, origin.row_fraction, nodes.rows);
    const bool is_x_fast = V::most(ray.x.speed) > V::most(ray.y.speed);
    const Float begin = V::select(m.runs, m.t, Float(__builtin_inff())) * (is_x_fast ? ray.x.speed : ray.y.speed);
    const std::int32_t slab = NarrowAxis::cell_at(is_x_fast ? x : y, V::least(begin) * (1 - 1e-6f));
    const std::int32_t next = is_x_fast ? march_slabs<V, Height, surface, true>(nodes, ray, x, y, slab, m)
                                        : march_slabs<V, Height, surface, false>(nodes, ray, y, x, slab, m);
    if (next == slab || !V::any(m.runs)) return;
    const Float since = is_x_fast ? RayAxis<V>::crossing(ray.x, Int(next)) : RayAxis<V>::crossing(ray.y, Int(next));
    m.t = V::select(m.runs, V::max(m.t, since), m.t);
    m.runs = m.runs & (m.t < m.leaves);
    m.column = V::select(m.runs, RayAxis<V>::cell_at(ray.x, m.t), m.column);
    m.row = V::select(m.runs, RayAxis<V>::cell_at(ray.y, m.t), m.row);
}

template <class V, class Height, CellSurface surface>
void trace_packet(const TileWork<V, Height>& tile, const BeamStarts& beams, std::uint32_t left, std::uint32_t top) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Shape = PacketShape<V>;
    float x[V::kCount], y[V::kCount], start[V::kCount];
    bool has_begun = false;
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        const std::uint32_t column = left + Shape::column(n), row = top + Shape::row(n);
        x[n] = static_cast<float>(column) + 0.5f;
        y[n] = static_cast<float>(row) + 0.5f;
        start[n] = beams.t[(row - tile.top) / 4 * (kTileWidth / 4) + (column - tile.left) / 4];
        has_begun |= start[n] < tile.job.span.to;
    }
    if (!has_begun && tile.job.goes_on) return;
    const std::uint32_t asked = asked_pixels<V>(tile.job, left, top);
    if (asked == 0) return;
    const Float at_x = V::load(x), at_y = V::load(y);
    const ViewOrigin& origin = tile.origin;
    RayLanes<V> ray = rays_from<V>(origin, tile.job.span);
    ray.x = RayAxis<V>::make(Int(origin.column), Float(origin.column_fraction), DirectionSlope::at<V>(tile.slopes.x, at_x, at_y));
    ray.y = RayAxis<V>::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(tile.slopes.y, at_x, at_y));
    ray.climb = DirectionSlope::at<V>(tile.slopes.z, at_x, at_y);
    March<V> m = enter<V, Height>(tile.nodes, ray, V::load(start), V::mask(asked), Int(0));
    if (V::any(m.runs)) march_near<V, Height, surface>(tile.nodes, ray, origin, m);
    if (V::any(m.runs)) march_cells<V, Height, surface, HitSide::above>(tile.nodes, ray, m, kMostCells);
    if (V::any(m.runs)) march_nodes<V, Height, surface, HitSide::above>(tile.nodes, ray, m);
    keep_packet<V, Height>(tile.job, tile.nodes.columns, ray, m, asked, left, top);
}

template <class V, class Height, CellSurface surface>
void trace_packets(const TileWork<V, Height>& tile, const BeamStarts& beams) {
    using Shape = PacketShape<V>;
    const ViewJob<Height>& job = tile.job;
    const std::uint32_t right = tile.left + kTileWidth < job.width ? tile.left + kTileWidth : job.width;
    const std::uint32_t bottom = tile.top + kTileHeight < job.height ? tile.top + kTileHeight : job.height;
    for (std::uint32_t top = tile.top; top < bottom; top += Shape::kHeight)
        for (std::uint32_t left = tile.left; left < right; left += Shape::kWidth)
            trace_packet<V, Height, surface>(tile, beams, left, top);
}

template <class V, class Height>
void trace_tile(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) {
    const TileWork<V, Height> tile(job, left, top);
    BeamStarts beams[2];
    for (int size = 0; size < kBeamSizes; ++size) {
        start_beams<V, Height>(tile, size, size == 0 ? nullptr : &beams[(size + 1) % 2], beams[size % 2]);
        if (size == 0 && job.goes_on && !(beams[0].t[0] < job.span.to)) return;  // all rays of the tile end before they meet
    }
    const BeamStarts& smallest = beams[(kBeamSizes - 1) % 2];
    if (job.field->surface == CellSurface::bilinear)
        trace_packets<V, Height, CellSurface::bilinear>(tile, smallest);
    else
        trace_packets<V, Height, CellSurface::two_triangles>(tile, smallest);
}

/// Columns that lie in vertical planes (is_swept()), V::kCount at a time.
template <class V, class Height>
void trace_columns(const ViewJob<Height>& job, std::uint32_t group) {
    const TracedNodes<Height> nodes(*job.field->maxima);
    if (job.field->surface == CellSurface::bilinear)
        sweep_columns<V, Height, CellSurface::bilinear>(job, nodes, group * V::kCount);
    else
        sweep_columns<V, Height, CellSurface::two_triangles>(job, nodes, group * V::kCount);
}

}  // namespace tedavis::raytrace
