/// Columns of a picture that each lie in one vertical plane: a column is swept once, outwards and upwards.
///
/// Where all rays of a column run over the same line on the ground, they cross the lines of the grid at the same times and differ
/// in their climb alone. What a steep one passes, a less steep one passes higher up, roundings included: so each ray goes on from
/// the cell where the one below it ended, and meets what it would meet alone, with the same bits.
///
/// After Lee and Shin 1997, "Rapid generation of virtual terrain views through a raycasting of height fields along vertical
/// ray coherence"; here without their approximations.
#pragma once

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/kernel/view_slopes.hpp"

namespace tedavis::raytrace {

/// Where neighbouring columns are: the next row of each, from the steepest.
template <class V>
struct ColumnSweep {
    typename V::Float x;
    typename V::Int row;     ///< of the picture
    std::int32_t step, end;  ///< to the next row; the row behind the last
};

template <class V>
TEDAVIS_LANES_INLINE typename V::Float climb_of(const ViewSlopes& slopes, const ColumnSweep<V>& sweep) {
    using Float = typename V::Float;
    return DirectionSlope::at<V>(slopes.z, sweep.x, V::to_float(sweep.row) + Float(0.5f));
}

/// Keeps what has been met, and lets the next rays of those columns go on from there.
template <class V, class Height>
TEDAVIS_LANES_INLINE void keep_and_go_on(const ViewJob<Height>& job, const ViewSlopes& slopes, std::uint32_t left,
                                         std::int32_t columns, ColumnSweep<V>& sweep, RayLanes<V>& ray, March<V>& m) {
    using Int = typename V::Int;
    float t[V::kCount], u[V::kCount], v[V::kCount];
    std::int32_t cell[V::kCount], row[V::kCount];
    V::store(t, m.met_t);
    const bool has_places = !job.picture.u.empty();
    if (has_places) {
        V::store(u, RayAxis<V>::place_in(ray.x, m.met_column, m.met_t));
        V::store(v, RayAxis<V>::place_in(ray.y, m.met_row, m.met_t));
    }
    V::store(cell, m.met_row * Int(columns) + m.met_column);
    V::store(row, sweep.row);
    const std::uint32_t beyond = V::bits(m.is_beyond);
    for (std::uint32_t met = V::bits(m.is_met); met != 0; met &= met - 1) {
        const auto n = static_cast<std::uint32_t>(__builtin_ctz(met));
        const auto y = static_cast<std::uint32_t>(row[n]);
        const std::size_t to = std::size_t{y} * job.width + left + n;
        job.picture.t.data()[to] = t[n];
        job.picture.cell.data()[to] = cell[n];
        job.picture.side.data()[to] = HitSide::above;
        if (has_places) {
            job.picture.u[to] = u[n];
            job.picture.v[to] = v[n];
        }
        if ((beyond >> n & 1) != 0) trace_pixel(job, left + n, y);
    }
    sweep.row = V::select(m.is_met, sweep.row + Int(sweep.step), sweep.row);
    ray.climb = climb_of(slopes, sweep);
    m.asks = V::without(m.is_met, sweep.row == Int(sweep.end));
    m.runs = V::without(m.runs, V::without(m.is_met, m.asks));
}

/// All rays of the columns that ask which meet the cells that they stand before.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void sweep_cells(const ViewJob<Height>& job, const TracedNodes<Height>& nodes, const ViewSlopes& slopes,
                                      std::uint32_t left, ColumnSweep<V>& sweep, RayLanes<V>& ray, March<V>& m) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Axis = RayAxis<V>;
    const Int one(1), column = m.column ^ ray.x.sign, row = m.row ^ ray.y.sign;
    const auto posts = CellPosts<V, Height>::gather(nodes, ray, column, row, m.asks);
    const Float t_in = V::max(V::max(Axis::crossing(ray.x, m.column), Axis::crossing(ray.y, m.row)), ray.from);
    const Float t_out = V::min(V::min(Axis::crossing(ray.x, m.column + one), Axis::crossing(ray.y, m.row + one)), ray.to);
    const auto profile = profile_of<V, Height, surface>(ray, posts, t_in, t_out);
    m.met_column = column;
    m.met_row = row;
    while (V::any(m.asks)) {
        const CellMeeting<V> meeting = meet_surface<V, surface, HitSide::above>(ray, profile);
        m.is_met = m.asks & meeting.is_met;
        m.is_beyond = m.is_met & meeting.is_beyond;
        m.met_t = meeting.t;
        m.passes = m.passes | V::without(m.asks, m.is_met);
        keep_and_go_on<V, Height>(job, slopes, left, nodes.columns, sweep, ray, m);
    }
}

/// Columns [left, left + V::kCount) of the picture, as far as it has them.
template <class V, class Height, CellSurface surface>
void sweep_columns(const ViewJob<Height>& job, const TracedNodes<Height>& nodes, std::uint32_t left) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const ViewOrigin origin = ViewOrigin::of(job.camera->origin);
    const ViewSlopes slopes(*job.camera);
    const std::uint32_t end = left + V::kCount < job.width ? left + V::kCount : job.width;
    clear_pixels(job.picture, job.width, left, 0, end, job.height);
    float middle[V::kCount];
    for (std::uint32_t n = 0; n < V::kCount; ++n) middle[n] = static_cast<float>(left + n) + 0.5f;
    const auto height = static_cast<std::int32_t>(job.height);
    const bool is_upwards = job.camera->down.z < 0;
    ColumnSweep<V> sweep{V::load(middle), Int(is_upwards ? height - 1 : 0), is_upwards ? -1 : 1, is_upwards ? -1 : height};
    RayLanes<V> ray = rays_from<V>(origin, RaySpan{});
    ray.x = RayAxis<V>::make(Int(origin.column), Float(origin.column_fraction),
                             DirectionSlope::at<V>(slopes.x, sweep.x, Float(0.5f)));
    ray.y = RayAxis<V>::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(slopes.y, sweep.x, Float(0.5f)));
    ray.climb = climb_of(slopes, sweep);
    const std::uint32_t all = end - left == 32 ? ~0u : (1u << (end - left)) - 1;
    March<V> m = enter<V, Height>(nodes, ray, ray.from, V::mask(all), Int(nodes.layout->top));
    while (V::any(m.runs)) {
        const auto steps = V::without(m.runs, m.asks);
        if (2 * __builtin_popcount(V::bits(m.asks)) < __builtin_popcount(V::bits(m.runs))) {
            step_node<V, Height, HitSide::above>(nodes, ray, m, steps);
            continue;
        }
        sweep_cells<V, Height, surface>(job, nodes, slopes, left, sweep, ray, m);
    }
}

}  // namespace tedavis::raytrace
