/// A band of a picture in lanes: its beams, from large to small, and then its rays.
#pragma once

#include "render_core/raytrace/kernel/beam_march.hpp"
#include "render_core/raytrace/kernel/column_sweep.hpp"
#include "render_core/raytrace/kernel/march_together.hpp"

namespace tedavis::raytrace {

/// Steps after which beams of each size are left where they are: those of their rays that get on do so alone.
inline constexpr int kMostBeamSteps[kBeamSizes] = {100, 100, 20, 12};
inline constexpr int kMostCells = 16;  ///< that rays pass one by one before they look at larger nodes

/// A row of beams of one size; `around` are those of the size before, null for the first.
template <class V, class Height>
void start_beams(const TracedNodes<Height>& nodes, const ViewOrigin& origin, const ViewSlopes& slopes, int size,
                 std::uint32_t row, const BeamStarts& beams, const BeamStarts* around) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const auto side = static_cast<float>(kBeamSide[size]), half = 0.5f * side;
    const Float y(static_cast<float>(row) * side + half);
    for (std::uint32_t first = 0; first < beams.across; first += V::kCount) {
        float middle[V::kCount], t[V::kCount];
        std::int32_t level[V::kCount];
        for (std::uint32_t n = 0; n < V::kCount; ++n) {
            const std::uint32_t at = first + n < beams.across ? first + n : beams.across - 1;
            middle[n] = static_cast<float>(at) * side + half;
            const std::size_t parent = around == nullptr ? 0 : std::size_t{row / 2} * around->across + at / 2;
            t[n] = around == nullptr ? 0 : around->t.data()[parent];
            level[n] = around == nullptr ? nodes.layout->top : around->level.data()[parent];
        }
        const Float x = V::load(middle);
        BeamLanes<V> b;
        b.x = BeamAxis<V>::make(DirectionSlope::at<V>(slopes.x, x, y), Float(DirectionSlope::reach(slopes.x, half)));
        b.y = BeamAxis<V>::make(DirectionSlope::at<V>(slopes.y, x, y), Float(DirectionSlope::reach(slopes.y, half)));
        b.least_climb =
            BeamAxis<V>::make(DirectionSlope::at<V>(slopes.z, x, y), Float(DirectionSlope::reach(slopes.z, half))).least;
        b.column = Int(origin.column);
        b.row = Int(origin.row);
        b.z = Int(origin.z);
        b.column_fraction = Float(origin.column_fraction);
        b.row_fraction = Float(origin.row_fraction);
        b.z_fraction = Float(origin.z_fraction);
        b.t = V::load(t);
        b.level = V::load(level);
        march_beams<V, Height>(nodes, b, kMostBeamSteps[size]);
        V::store(t, b.t);
        V::store(level, b.level);
        const std::size_t to = std::size_t{row} * beams.across + first;
        for (std::uint32_t n = 0; n < V::kCount && first + n < beams.across; ++n) {
            beams.t.data()[to + n] = t[n];
            beams.level.data()[to + n] = level[n];
        }
    }
}

/// Lanes that are traced together: 4 x 4 pixels of a beam, or a part of those, or those of neighbouring beams.
template <class V>
struct PacketShape {
    static constexpr std::uint32_t kWidth = V::kCount > 16 ? V::kCount / 4 : V::kCount < 4 ? V::kCount : 4;
    static constexpr std::uint32_t kHeight = V::kCount / kWidth;
    static constexpr std::uint32_t column(std::uint32_t lane) { return lane % 4 + lane / 16 * 4; }
    static constexpr std::uint32_t row(std::uint32_t lane) { return lane % 16 / 4; }
};

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
void trace_packet(const ViewJob<Height>& job, const TracedNodes<Height>& nodes, const ViewOrigin& origin,
                  const ViewSlopes& slopes, std::uint32_t left, std::uint32_t top) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Shape = PacketShape<V>;
    const BeamStarts& beams = job.beams[kBeamSizes - 1];
    float x[V::kCount], y[V::kCount], start[V::kCount];
    std::int32_t level[V::kCount];
    std::uint32_t inside = 0;
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        const std::uint32_t column = left + Shape::column(n), row = top + Shape::row(n);
        const bool is_inside = column < job.width && row < job.height;
        inside |= (is_inside ? 1u : 0u) << n;
        x[n] = static_cast<float>(column) + 0.5f;
        y[n] = static_cast<float>(row) + 0.5f;
        const std::size_t beam = is_inside ? std::size_t{row / 4} * beams.across + column / 4 : 0;
        start[n] = beams.t.data()[beam];
        level[n] = beams.level.data()[beam];
    }
    const Float at_x = V::load(x), at_y = V::load(y);
    RayLanes<V> ray = rays_from<V>(origin);
    ray.x = RayAxis<V>::make(Int(origin.column), Float(origin.column_fraction), DirectionSlope::at<V>(slopes.x, at_x, at_y));
    ray.y = RayAxis<V>::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(slopes.y, at_x, at_y));
    ray.climb = DirectionSlope::at<V>(slopes.z, at_x, at_y);
    March<V> m = enter<V, Height>(nodes, ray, V::load(start), V::mask(inside), V::load(level));
    if (V::any(m.runs)) march_near<V, Height, surface>(nodes, ray, origin, m);
    if (V::any(m.runs)) march_cells<V, Height, surface, HitSide::above>(nodes, ray, m, kMostCells);
    if (V::any(m.runs)) march_nodes<V, Height, surface, HitSide::above>(nodes, ray, m);

    float t[V::kCount];
    std::int32_t cell[V::kCount];
    V::store(t, V::select(m.is_met, m.met_t, Float(__builtin_inff())));
    V::store(cell, V::select(m.is_met, m.met_row * Int(nodes.columns) + m.met_column, Int(-1)));
    const std::uint32_t beyond = V::bits(m.is_beyond);
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        if ((inside >> n & 1) == 0) continue;
        const std::size_t to = std::size_t{top + Shape::row(n)} * job.width + left + Shape::column(n);
        job.t[to] = t[n];
        job.cell[to] = cell[n];
        job.side[to] = cell[n] < 0 ? HitSide::none : HitSide::above;
        if ((beyond >> n & 1) != 0) trace_pixel(job, left + Shape::column(n), top + Shape::row(n));
    }
}

template <class V, class Height>
void trace_band(const ViewJob<Height>& job, std::uint32_t band) {
    using Shape = PacketShape<V>;
    const TracedNodes<Height> nodes(*job.field->maxima);
    const ViewOrigin origin = ViewOrigin::of(job.camera->origin);
    const ViewSlopes slopes(*job.camera);
    for (int size = 0; size < kBeamSizes; ++size) {
        const std::uint32_t rows = kBandRows / kBeamSide[size];
        for (std::uint32_t row = band * rows; row < (band + 1) * rows && row < job.beams[size].down; ++row)
            start_beams<V, Height>(nodes, origin, slopes, size, row, job.beams[size], size == 0 ? nullptr : &job.beams[size - 1]);
    }
    const std::uint32_t end = (band + 1) * kBandRows < job.height ? (band + 1) * kBandRows : job.height;
    const bool is_patch = job.field->surface == CellSurface::bilinear;
    for (std::uint32_t top = band * kBandRows; top < end; top += Shape::kHeight)
        for (std::uint32_t left = 0; left < job.width; left += Shape::kWidth)
            if (is_patch)
                trace_packet<V, Height, CellSurface::bilinear>(job, nodes, origin, slopes, left, top);
            else
                trace_packet<V, Height, CellSurface::two_triangles>(job, nodes, origin, slopes, left, top);
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
