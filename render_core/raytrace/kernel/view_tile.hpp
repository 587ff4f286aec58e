/// Traces a tile of a picture in lanes: its beams, from large to small, then its rays.
#pragma once

#include <algorithm>
#include <type_traits>

#include "render_core/raytrace/kernel/beam_march.hpp"
#include "render_core/raytrace/kernel/loose_rays.hpp"
#include "render_core/raytrace/kernel/march_together.hpp"

namespace tedavis::raytrace {

/// Sides of beams, in pixels: kBeamSide[0] is traced first; each further beam starts where the surrounding one ended.
inline constexpr int kBeamSizes = 3;
inline constexpr std::uint32_t kBeamSide[kBeamSizes] = {16, 8, 4};
/// Largest number of steps for beams of each size; their rays then continue in smaller beams or alone.
inline constexpr int kMaxBeamSteps[kBeamSizes] = {150, 12, 8};
inline constexpr int kMaxCells = 16;  ///< cells that rays traverse one by one before they use larger nodes

/// Number of beams of a size across a tile.
constexpr std::uint32_t beams_across(int size) { return kTileWidth / kBeamSide[size]; }
constexpr std::uint32_t beam_count(int size) { return beams_across(size) * (kTileHeight / kBeamSide[size]); }

/// Start times of beams of one size, row by row; whole vectors of lanes are written.
struct BeamStarts {
    float t[beam_count(kBeamSizes - 1)];
    std::int32_t level[beam_count(kBeamSizes - 1)];  ///< level of the last nodes
};

/// The lane type for the beams of a size; narrower where a tile has fewer beams.
template <class V, int size>
using NarrowFor = std::conditional_t<(beam_count(size) < V::kCount), typename V::Narrow, V>;

/// Traces the beams of one size; `around` are those of the size before, null for the first.
template <class V, int size, class Tile>
void start_beams(const Tile& tile, const BeamStarts* around, BeamStarts& beams) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    constexpr std::uint32_t kSide = kBeamSide[size], kAcross = beams_across(size), kCount = beam_count(size);
    constexpr float kHalf = 0.5f * static_cast<float>(kSide);
    for (std::uint32_t first = 0; first < kCount; first += V::kCount) {
        float x[V::kCount], y[V::kCount], t[V::kCount];
        std::int32_t level[V::kCount];
        for (std::uint32_t n = 0; n < V::kCount; ++n) {
            const std::uint32_t at = (first + n) % kCount, column = at % kAcross, row = at / kAcross;
            x[n] = static_cast<float>(tile.left + column * kSide) + kHalf;
            y[n] = static_cast<float>(tile.top + row * kSide) + kHalf;
            const std::uint32_t parent = row / 2 * (kAcross / 2) + column / 2;
            t[n] = around == nullptr ? tile.job.span.from : around->t[parent];
            level[n] = around == nullptr ? tile.nodes.layout->top : around->level[parent];
        }
        const Float at_x = V::load(x), at_y = V::load(y);
        const auto axis = [&](const DirectionSlope& slope) TEDAVIS_LANES_LAMBDA {
            return BeamAxis<V>::make(DirectionSlope::at<V>(slope, at_x, at_y), Float(DirectionSlope::reach(slope, kHalf)));
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
        march_beams<V>(tile.nodes, b, kMaxBeamSteps[size]);
        V::store(beams.t + first, b.t);
        V::store(beams.level + first, b.level);
    }
}

/// Traces rays while they are coherent; rays that continue alone keep their cells.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void march_near(const TracedNodes<Height>& nodes, const RayLanes<V>& ray, const ViewOrigin& origin,
                                     TraversalState<V>& m) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    if (!NarrowAxis::is_one_way<V>(ray.x) || !NarrowAxis::is_one_way<V>(ray.y)) return enter_cells<V, Height>(nodes, ray, m);
    const NarrowAxis x = NarrowAxis::make(V::any(ray.x.sign < Int(0)), origin.column, origin.column_fraction, nodes.columns);
    const NarrowAxis y = NarrowAxis::make(V::any(ray.y.sign < Int(0)), origin.row, origin.row_fraction, nodes.rows);
    const bool is_x_fast = V::most(ray.x.speed) > V::most(ray.y.speed);
    const Float begin = V::select(m.runs, m.t, Float(__builtin_inff())) * (is_x_fast ? ray.x.speed : ray.y.speed);
    const std::int32_t slab = NarrowAxis::cell_at(is_x_fast ? x : y, V::least(begin) * (1 - 1e-6f));
    const std::int32_t next = is_x_fast ? march_slabs<V, Height, surface, true>(nodes, ray, x, y, slab, m)
                                        : march_slabs<V, Height, surface, false>(nodes, ray, y, x, slab, m);
    if (next == slab) return enter_cells<V, Height>(nodes, ray, m);
    if (!V::any(m.runs)) return;
    const Float since = is_x_fast ? RayAxis<V>::crossing(ray.x, Int(next)) : RayAxis<V>::crossing(ray.y, Int(next));
    m.t = V::select(m.runs, V::max(m.t, since), m.t);
    m.runs = m.runs & (m.t < m.leaves);
    m.column = V::select(m.runs, RayAxis<V>::cell_at(ray.x, m.t), m.column);
    m.row = V::select(m.runs, RayAxis<V>::cell_at(ray.y, m.t), m.row);
}

template <class V, class Height, CellSurface surface>
void trace_packet(const TileWork<V, Height>& tile, const BeamStarts& beams, std::uint32_t left, std::uint32_t top,
                  LooseRays<V>& loose) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Shape = PacketShape<V>;
    const float* const starts = beams.t + (top - tile.top) / 4 * (kTileWidth / 4) + (left - tile.left) / 4;
    Float start(starts[0]);
    if constexpr (Shape::kWidth > 4) start = V::select(V::mask(~0u << 16), Float(starts[1]), start);
    if (!(V::least(start) < tile.job.span.to)) {
        if (!tile.job.goes_on) clear_packet<V, Height>(tile.job, left, top);
        return;
    }
    const std::uint32_t asked = asked_pixels<V>(tile.job, left, top);
    if (asked == 0) return;
    constexpr PacketMiddles<V> kMiddles;
    const Float at_x = Float(static_cast<float>(left)) + V::load(kMiddles.x);
    const Float at_y = Float(static_cast<float>(top)) + V::load(kMiddles.y);
    const RayLanes<V> ray = tile.rays(at_x, at_y);
    TraversalState<V> m = enter_times<V, Height>(tile.nodes, ray, start, V::mask(asked), Int(0));
    if (V::any(m.runs)) march_near<V, Height, surface>(tile.nodes, ray, tile.origin, m);
    if (V::any(m.runs)) march_cells<V, Height, surface, HitSide::above>(tile.nodes, ray, m, kMaxCells);
    const std::uint32_t runs = V::bits(m.runs);
    if (runs != 0) loose.take(runs, at_x, at_y, m.t, m.level);
    if (runs != asked) keep_packet<V, Height>(tile.job, tile.nodes.columns, ray, m, asked & ~runs, left, top);
}

template <class V, class Height, CellSurface surface>
void trace_packets(const TileWork<V, Height>& tile, const BeamStarts& beams) {
    using Shape = PacketShape<V>;
    const ViewJob<Height>& job = tile.job;
    const std::uint32_t right = tile.left + kTileWidth < job.width ? tile.left + kTileWidth : job.width;
    const std::uint32_t bottom = tile.top + kTileHeight < job.height ? tile.top + kTileHeight : job.height;
    LooseRays<V> loose;
    for (std::uint32_t top = tile.top; top < bottom; top += Shape::kHeight)
        for (std::uint32_t left = tile.left; left < right; left += Shape::kWidth)
            trace_packet<V, Height, surface>(tile, beams, left, top, loose);
    trace_loose<V, Height, surface>(tile, loose);
}

template <class V, class Height>
void trace_tile(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) {
    const TileWork<V, Height> tile(job, left, top);
    BeamStarts large, small;
    start_beams<NarrowFor<V, 0>, 0>(tile, nullptr, small);
    if (job.goes_on && !(*std::min_element(small.t, small.t + beam_count(0)) < job.span.to))
        return;  // nothing is hit before the end
    start_beams<NarrowFor<V, 1>, 1>(tile, &small, large);
    start_beams<NarrowFor<V, 2>, 2>(tile, &large, small);
    if (job.field->surface == CellSurface::bilinear)
        trace_packets<V, Height, CellSurface::bilinear>(tile, small);
    else
        trace_packets<V, Height, CellSurface::two_triangles>(tile, small);
}

}  // namespace tedavis::raytrace
